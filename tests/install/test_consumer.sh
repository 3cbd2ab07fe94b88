#!/bin/sh
# test_consumer.sh BUILD VERSION CFLAGS: installs a build under a prefix of its own and builds a program against it as a
# user would, once through find_package and once through pkg-config.
set -eu
build=$1 version=$2 flags=$3
source=$(dirname "$(readlink -f "$0")")/consumer
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix

cmake --install "$build" --prefix "$prefix" >/dev/null
PKG_CONFIG_LIBDIR=$(dirname "$(find "$prefix" -name pdmc.pc)") # ours alone
export CFLAGS="$flags" PKG_CONFIG_LIBDIR

cmake -S "$source" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$prefix" >"$work/log" || { cat "$work/log"; exit 1; }
cmake --build "$work/cmake" >"$work/log" || { cat "$work/log"; exit 1; }
[ "$("$work/cmake/consumer")" = "$version" ]

library_dir=$(pkg-config --variable=libdir pdmc)
# shellcheck disable=SC2046,SC2086 # lists of flags
cc $flags "$source/main.c" $(pkg-config --cflags --libs pdmc) -Wl,-rpath,"$library_dir" -o "$work/consumer"
[ "$("$work/consumer")" = "$version" ]
[ "$(pkg-config --modversion pdmc)" = "$version" ]

# Meshes need the module that lies beside the library, and nothing else does.
cat >"$work/triangles.cfg" <<'END'
kind = "scalar"; domain = { dimension = 2; width = 1.0; height = 1.0; }; kernel = { horizon = 0.3; };
elements = { mesh = "triangles"; spacing = 0.4; }; wave = { length = 2.0; }; convergence = { levels = 2; };
END
"$prefix/bin/pdmc" -q -o "$work/triangles.h5" "$work/triangles.cfg"
find "$prefix" -name libpdmc_gmsh.so -delete
if "$prefix/bin/pdmc" -q -f -o "$work/triangles.h5" "$work/triangles.cfg" 2>"$work/log"; then status=0; else status=$?; fi
grep -q '^pdmc: meshes of triangles and .msh files need Gmsh' "$work/log" || { cat "$work/log"; exit 1; }
[ "$status" -ne 0 ] || { echo 'a mesh without Gmsh'; exit 1; }
[ "$("$prefix/bin/pdmc" --version | cut -d' ' -f2)" = "$version" ]

if "$prefix/bin/pdmc" >/dev/null 2>&1; then status=0; else status=$?; fi
[ "$status" -eq 64 ] || { echo "the installed command without arguments: exit $status, not 64 (usage)"; exit 1; }
