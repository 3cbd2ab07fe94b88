// SPDX-License-Identifier: GPL-3.0-or-later
#define _GNU_SOURCE // dladdr()
#include "base/base_impl.h"
#include "mesh/gmsh.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { PATH_SIZE = 4096 };

// The file that this code is in. Of a program it may be as it was called, from a folder that has been left since.
static void find_self(char path[PATH_SIZE])
{
    static const char here = 0;
    Dl_info self;
    const bool is_known = dladdr(&here, &self) && self.dli_fname;
    if (is_known) snprintf(path, PATH_SIZE, "%s", self.dli_fname);
    if (is_known && *path == '/') return;
    const ssize_t length = readlink("/proc/self/exe", path, PATH_SIZE - 1);
    path[length > 0 ? length : 0] = '\0';
}

// The module lies beside the library. Programs that are made of the library's objects, as tests are, lie in a folder beside
// that of the libraries. The linker's own search would do, but for the address sanitizer, which calls dlopen() in our place.
static void find_module(char path[PATH_SIZE])
{
    static const char *const places[] = {"", "../lib/"};
    char self[PATH_SIZE];
    find_self(self);
    const char *slash = strrchr(self, '/');
    const int folder = slash ? (int)(slash - self) + 1 : 0;
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        snprintf(path, PATH_SIZE, "%.*s%slibpdmc_gmsh.so", folder, self, places[i]);
        if (access(path, R_OK) == 0) return;
    }
    snprintf(path, PATH_SIZE, "libpdmc_gmsh.so");
}

// ISO C has no conversion between the two kinds of pointers; POSIX does.
static bool find_function(void *module, const char *name, void *function)
{
    void *address = dlsym(module, name);
    memcpy(function, &address, sizeof address);
    return address;
}

// It stays loaded: the libraries behind Gmsh cannot all be unloaded.
pdmc_status pdmc_gmsh_load(pdmc_gmsh *gmsh)
{
    char path[PATH_SIZE];
    find_module(path);
    void *module = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (module && find_function(module, "pdmc_gmsh_version", &gmsh->version) &&
        find_function(module, "pdmc_gmsh_read", &gmsh->read) &&
        find_function(module, "pdmc_gmsh_plate", &gmsh->plate) &&
        find_function(module, "pdmc_gmsh_clear", &gmsh->clear))
        return PDMC_OK;
    return pdmc_raise(PDMC_ERR_EXTERN,
                      "meshes of triangles and .msh files need Gmsh, whose part of pdmc cannot be loaded: %s",
                      dlerror());
}
