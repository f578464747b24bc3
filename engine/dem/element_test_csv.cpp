#include "dem/element_test_csv.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>
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
void write(const std::filesystem::path& file, std::span<const Row> rows, const std::string& metadata,
           std::string_view more_columns) {
    std::ofstream out(file, std::ios::binary);
    out << "# " << metadata << '\n' << path_columns << more_columns << '\n';
    for (const Row& row : rows) out << line(row) << '\n';
    if (!out.flush()) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

}  // namespace

void write_element_csv(const std::filesystem::path& file, std::span<const ElementRow> rows,
                       const std::string& metadata) {
    write(file, rows, metadata, "");
}

void write_element_csv(const std::filesystem::path& file, std::span<const BiaxialRow> rows,
                       const std::string& metadata) {
    write(file, rows, metadata, biaxial_columns);
}

void write_element_csv(const std::filesystem::path& file, std::span<const ShearRow> rows,
                       const std::string& metadata) {
    write(file, rows, metadata, shear_columns);
}

}  // namespace sandgraph::dem
