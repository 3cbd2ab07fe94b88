#include "bond/bond_plate.h"
#include <string.h>
#include <time.h>
static double cpu(void){struct timespec t; clock_gettime(CLOCK_THREAD_CPUTIME_ID,&t); return (double)t.tv_sec+1e-9*(double)t.tv_nsec;}
static void go(int n, double ratio){
    bond_plate p; bond_plate_describe(&p,n,n,ratio); p.problem.solver.area=PDMC_AREA_FULL;
    bond_plate_crack(&p,-1,0,1,0); bond_plate_make(&p,100);
    size_t un=2*(size_t)n*n; int sh=p.made.horizon.shells;
    double*x=pdmc_calloc(un*64,8),*y=pdmc_calloc(un*64,8),*f=pdmc_calloc(64*sh,8);
    for(size_t i=0;i<un*64;i++)x[i]=(double)((i*2654435761u)%1000)/1000; for(int i=0;i<64*sh;i++)f[i]=1+0.001*i;
    double best=1e9; for(int r=0;r<25;r++){double t=cpu(); CHECK_OK(pdmc_bond_multiply(&p.made,f,x,y)); t=cpu()-t; if(t<best)best=t;}
    double bonds=(double)p.made.families.start[n*n];
    uint64_t h=0; for(size_t i=0;i<un*64;i++){uint64_t b; memcpy(&b,&y[i],8); h=h*31+b;}
    printf("n %d ratio %g bonds %g: %.3f ms/column, %.1f Gflop/s, %.1f GB/s of vectors gathered (%.1f compulsory) hash %lx\n",n,ratio,bonds,best*1e3/64,bonds*10*64/best*1e-9,bonds*16*64/best*1e-9,(un*64*8*4.0+8*bonds*6)/best*1e-9,(long)h);
}
int main(void){go(101,5);}
