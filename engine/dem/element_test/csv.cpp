#include "dem/element_test/element_test.hpp"

#include <fmt/format.h>

#include <string_view>

namespace sandgraph::dem {
namespace {

constexpr std::string_view path_columns =
    "step,t,Fxx,Fxy,Fyx,Fyy,hxx,hxy,hyx,hyy,sxx,sxy,syx,syy,n,Nc,Z,Zm,phixx,phixy,phiyy,Fa,slide_frac,"
    "E_el_n,E_el_t,E_el_r,E_k_trans,E_k_rot,un_max";
constexpr std::string_view biaxial_columns = ",eps_a,eps_v,p,q,sin_phi,I";
constexpr std::string_view shear_columns = ",gamma,eps_v,p,q,q_over_p,I";

std::string numbers(std::initializer_list<double> values) {
    std::string text;
    for (double v : values) text += fmt::format(",{:.12g}", v);
    return text;
}

std::string tensor(const Mat2& a) { return numbers({a(0, 0), a(0, 1), a(1, 0), a(1, 1)}); }

std::string line(const ElementRow& row) {
    const Observables& o = row.seen;
    return fmt::format("{}", row.step) + numbers({row.time}) + tensor(row.F) + tensor(row.H) +
           tensor(o.stress) + numbers({o.porosity}) + fmt::format(",{}", o.contacts) +
           numbers({o.coordination, o.mechanical_coordination, o.fabric(0, 0), o.fabric(0, 1), o.fabric(1, 1),
                    o.anisotropy, o.sliding_fraction, o.elastic_normal, o.elastic_tangential,
                    o.elastic_rolling, o.kinetic_translation, o.kinetic_rotation, o.overlap_max});
}

std::string line(const BiaxialRow& row) {
    return line(static_cast<const ElementRow&>(row)) +
           numbers({row.axial_strain, row.volumetric_strain, row.p, row.q, row.sin_phi, row.inertial_number});
}

std::string line(const ShearRow& row) {
    return line(static_cast<const ElementRow&>(row)) +
           numbers({row.shear_strain, row.volumetric_strain, row.p, row.q, row.stress_ratio,
                    row.inertial_number});
}

template <class Row>
std::string text(std::span<const Row> rows, const std::string& metadata, std::string_view more_columns) {
    std::string out = fmt::format("# {}\n{}{}\n", metadata, path_columns, more_columns);
    for (const Row& row : rows) out += line(row) + '\n';
    return out;
}

}  // namespace

std::string element_csv(std::span<const ElementRow> rows, const std::string& metadata) {
    return text(rows, metadata, "");
}

std::string element_csv(std::span<const BiaxialRow> rows, const std::string& metadata) {
    return text(rows, metadata, biaxial_columns);
}

std::string element_csv(std::span<const ShearRow> rows, const std::string& metadata) {
    return text(rows, metadata, shear_columns);
}

}  // namespace sandgraph::dem
