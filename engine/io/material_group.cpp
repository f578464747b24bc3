#include "io/material_group.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "io/h5_attribute.hpp"

namespace sandgraph::io {
namespace {

struct Parameter {
    const char* name;
    double dem::Material::*member;
    bool may_be_zero;
    double limit;  // below which it must lie
};

constexpr double none = std::numeric_limits<double>::infinity();
constexpr std::array<Parameter, 8> parameters{{
    {"density", &dem::Material::density, false, none},
    {"young", &dem::Material::young, false, none},
    {"stiffness_ratio", &dem::Material::stiffness_ratio, true, none},
    {"friction_angle", &dem::Material::friction_angle, true, std::numbers::pi / 2},
    {"rolling_stiffness", &dem::Material::rolling_stiffness, true, none},
    {"rolling_limit", &dem::Material::rolling_limit, true, none},
    {"damping", &dem::Material::damping, true, 1},
    {"depth", &dem::Material::depth, false, none},
}};

void check(const h5::Group& group, const Parameter& p, double value) {
    const bool above = p.may_be_zero ? value >= 0 : value > 0;
    if (!above || !(value < p.limit))
        h5::refuse(
            group, fmt::format("material {} = {:g}", p.name, value),
            fmt::format("it must be {} 0 and below {:g}", p.may_be_zero ? "at least" : "above", p.limit));
}

}  // namespace

void write_material(h5::Group group, const dem::Material& material) {
    for (const Parameter& p : parameters) h5::set_attribute(group, ".", p.name, material.*p.member);
    const bool total = material.rolling_form == dem::RollingForm::total;
    h5::set_attribute(group, ".", "rolling_form", std::string(total ? "total" : "incremental"));
}

dem::Material read_material(const h5::Group& group) {
    dem::Material material;
    for (const Parameter& p : parameters) {
        material.*p.member = h5::get_real(group, ".", p.name);
        check(group, p, material.*p.member);
    }
    const std::string form = h5::get_text(group, ".", "rolling_form");
    if (form != "total" && form != "incremental")
        h5::refuse(group, "rolling_form = " + form, "known: incremental, total");
    material.rolling_form = form == "total" ? dem::RollingForm::total : dem::RollingForm::incremental;
    return material;
}

}  // namespace sandgraph::io
