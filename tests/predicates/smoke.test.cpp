#include <catch2/catch.hpp>
#include "predicates/oracle.h"
#include "predicates/construct.h"
using namespace suture;
TEST_CASE("smoke"){ for (auto a:{Arithmetic::filtered,Arithmetic::rational}) {auto o=make_oracle(a);
 CHECK(o->edge_side({0,0,0},{0,1,0},{0,1,0.,.5})==-1);
 CHECK(o->triangle_side({0,0,0},{1,0,0},{0,1,0},{0,0,0})==1);
 CHECK(o->triangle_side({0,0,0},{1,0,1},{0,1,0},{0,0,0})==-1);
 }
 CHECK(on_edge({0,0,0},{3,1,0},0,1,1)==1./3);
 CHECK(on_triangle({0,0,0},{3,0,1},{0,1,0},2,{1,0.5,0})==1./3);
 }
