#pragma once
#include <span>
#include <string>

#include "dem/element_test/element_test.hpp"

namespace sandgraph::dem {

// Rows as CSV with the column names, signs and units of the YADE files, after one '#' line of JSON
// `metadata`. Path and isotropic tests:
//   step,t,Fxx,Fxy,Fyx,Fyy,hxx,hxy,hyx,hyy,sxx,sxy,syx,syy,n,Nc,Z,Zm,phixx,phixy,phiyy,Fa,slide_frac,
//   E_el_n,E_el_t,E_el_r,E_k_trans,E_k_rot,un_max
// Biaxial tests have these and then eps_a,eps_v,p,q,sin_phi,I; shear tests gamma,eps_v,p,q,q_over_p,I.
std::string element_csv(std::span<const ElementRow> rows, const std::string& metadata = "{}");
std::string element_csv(std::span<const BiaxialRow> rows, const std::string& metadata = "{}");
std::string element_csv(std::span<const ShearRow> rows, const std::string& metadata = "{}");

}  // namespace sandgraph::dem
