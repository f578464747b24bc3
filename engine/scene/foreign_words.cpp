#include "scene/foreign_words.hpp"

#include <algorithm>
#include <cctype>

namespace sandgraph::scene {
namespace {

struct Entry {
    std::string_view table;  // any_table: wherever it stands
    std::string_view words;  // in lower case without '_', parted by blanks
    const char* why;
    const char* advice;
};

constexpr const char* leave_out = "leave it out";
constexpr const char* angle_of_what =
    "several things have one: the contacts of grains, closed-form ground, the plate";
constexpr const char* angle_advice =
    "write grains.friction_angle (rve), continuum.friction_angle (mohr_coulomb) or, for plate against soil, "
    "anchor.friction_angle";
constexpr const char* grains_tell =
    "not supported with grains: what sand does as a whole is the answer of its packing";
constexpr const char* dry = "not supported: the ground is dry";
constexpr const char* uniform = "not supported: one uniform ground";
constexpr const char* one_plate = "not supported: one rigid plate, pulled at a given speed";
constexpr const char* fixed_sides =
    "not supported: the base is fixed, the sides are smooth, the surface is free";
constexpr const char* grid = "not supported: one uniform grid of square cells";
constexpr const char* laws = "not supported: ground.law is rve, elastic or mohr_coulomb";

// Words of PLAXIS, OptumG2, Anura3D, CB-Geo, Taichi MPM, YADE and of soil mechanics.
constexpr Entry entries[] = {
    {"ground", "frictionangle phi phi' phip friction", angle_of_what, angle_advice},
    {"", "frictionangle phi friction", angle_of_what, angle_advice},
    {"domain", "frictionangle phi", angle_of_what, angle_advice},
    {"grains", "cohesion c cohesive adhesion bond bondstrength normalcohesion shearcohesion",
     "not supported: grains do not stick together",
     "write continuum.cohesion, with ground.law = \"mohr_coulomb\""},
    {"grains", "poisson nu v poissonratio", "not supported: contacts are springs",
     "write grains.stiffness_ratio, k_t/k_n"},
    {"grains", "dilationangle dilatancyangle dilatancy psi dilation", grains_tell,
     "write continuum.dilation_angle, with ground.law = \"mohr_coulomb\""},
    {"grains", "kn ks kt stiffness normalstiffness e e50", "contacts have a modulus, k_n = E r*",
     "write grains.young and grains.stiffness_ratio"},
    {"grains", "rollingfriction rollingresistance etaroll krot eta beta alphakr", "it goes by another name",
     "write grains.rolling_limit (eta) and grains.rolling_stiffness (beta)"},
    {"grains", "mu frictioncoefficient phi friction", "friction is an angle here",
     "write grains.friction_angle"},
    {"grains", "porosity voidratio relativedensity dr id e0 n initialporosity", "it goes by another name",
     "write grains.density = \"custom\" and grains.target_porosity"},
    {"grains", "d50 diameter radius rmean rmin rmax d10 d60 cu", "sizes are uniform between two radii",
     "write grains.radius_min and grains.radius_max"},
    {"grains", "restitution coefficientofrestitution viscosity dashpot cn viscousdamping",
     "not supported: energy goes by friction and local damping", "write grains.damping"},
    {"grains", "shape clump aspectratio sphericity polygon", "not supported: grains are disks", leave_out},
    {"ground", "density rho unitweight gamma gammaunsat weight", "the ground weighs what its sand weighs",
     "write grains.grain_density (rve) or continuum.density (closed-form laws)"},
    {"ground",
     "young e eref e50 e50ref eoed eoedref eur eurref g gref g0 stiffness modulus shearmodulus bulkmodulus",
     "stiffness belongs to the law", "write grains.young (rve) or continuum.young (closed-form laws)"},
    {"ground", "poisson nu poissonratio nuur", "not supported with grains; closed-form laws have it",
     "write continuum.poisson, with ground.law = \"elastic\" or \"mohr_coulomb\""},
    {"ground", "cohesion c cref", "not supported with grains; mohr_coulomb has it",
     "write continuum.cohesion, with ground.law = \"mohr_coulomb\""},
    {"ground", "dilationangle dilatancyangle dilatancy psi dilation", grains_tell,
     "write continuum.dilation_angle, with ground.law = \"mohr_coulomb\""},
    {"ground", "porosity voidratio relativedensity dr e0 n", "it belongs to the packing",
     "write grains.density, or with \"custom\" grains.target_porosity"},
    {"ground", "model soilmodel material materialmodel constitutivemodel", "it goes by another name",
     "write ground.law"},
    {"ground", "load pressure q traction surfaceload", "it goes by another name", "write ground.surcharge"},
    {"continuum", "e eref e50 e50ref g gref shearmodulus bulkmodulus k", "stiffness is E and nu here",
     "write continuum.young and continuum.poisson"},
    {"continuum", "nu v poissonratio nuur", "it goes by another name", "write continuum.poisson"},
    {"continuum", "phi friction phip", "it goes by another name", "write continuum.friction_angle"},
    {"continuum", "psi dilatancy dilatancyangle dilation", "it goes by another name",
     "write continuum.dilation_angle"},
    {"continuum", "c cref su undrainedshearstrength", "it goes by another name",
     "write continuum.cohesion (undrained: with friction_angle = \"0 deg\")"},
    {"continuum", "rho unitweight gamma gammaunsat weight", "it goes by another name",
     "write continuum.density, unit weight over gravity"},
    {"anchor", "load force moment pullload capacity", one_plate, "write anchor.pull_rate and anchor.pull_to"},
    {"anchor", "velocity speed rate v displacementrate", "it goes by another name", "write anchor.pull_rate"},
    {"anchor", "displacement travel pull", "it goes by another name",
     "write anchor.pull_to, in plate widths"},
    {"anchor", "roughness interface rinter interfacestrength mu frictioncoefficient delta",
     "it goes by another name", "write anchor.friction_angle"},
    {"anchor", "depth embedment h", "not supported: depth is told in plate widths",
     "write anchor.embedment_ratio, H/B"},
    {"anchor", "b size diameter length height", "it goes by another name", "write anchor.width"},
    {"anchor", "young stiffness ei ea mass density weight", "not supported: the plate is rigid and driven",
     leave_out},
    {"anchor", "angle inclination pulldirection motion shape type",
     "not supported: a horizontal or a vertical plate, pulled along its normal", "write anchor.orientation"},
    {"domain", "cellsize dx h meshsize elementsize resolution ngrid spacing", "it goes by another name",
     "write domain.cell"},
    {"domain", "height", "it goes by another name", "write domain.depth"},
    {"domain", "particlespercell ppc npcell mpspercell materialpointspercell particles",
     "it goes by another name", "write domain.points_per_cell"},
    {"domain", "boundary boundaries boundaryconditions bc symmetry fixities", fixed_sides, leave_out},
    {"mpm", "timestep dt dtmax maxdt timeincrement", "not supported: the step follows from the P-wave",
     "write mpm.courant"},
    {"mpm", "flip flipratio alpha pic apic xpic transfer", "the transfer is FLIP with a share of PIC",
     "write mpm.pic_fraction"},
    {"mpm", "localdamping dampingfactor viscosity bulkviscosity", "it goes by another name",
     "write mpm.damping"},
    {"mpm", "steps nsteps numsteps duration totaltime tend maxtime", "it goes by another name",
     "write anchor.pull_to, or without an anchor mpm.end_time"},
    {"mpm", "scheme update usf usl musl shape shapefunction gimp cpdi bspline",
     "not supported: GIMP on one grid", leave_out},
    {"*", "k0 k0x k0nc lateralpressure earthpressure", "it goes by another name", "write ground.k0"},
    {"*", "ocr pop preconsolidation overconsolidationratio",
     "not supported: sand starts at its in-situ stress", leave_out},
    {"*",
     "watertable waterlevel phreaticlevel groundwater water porepressure porewaterpressure pwp skempton "
     "drainage drained undrained permeability hydraulicconductivity kx ky saturation gammasat fluid",
     dry, leave_out},
    {"*", "unitweight", "the ground weighs what its sand weighs",
     "write grains.grain_density (rve) or continuum.density (closed-form laws)"},
    {"*", "su cu undrainedshearstrength sref suinc", "not supported with grains; mohr_coulomb has a cohesion",
     "write continuum.cohesion and continuum.friction_angle = \"0 deg\""},
    {"*", "tensioncutoff tensilestrength", "not supported", leave_out},
    {"*", "layer layers soillayer soillayers stratum strata borehole", uniform, leave_out},
    {"*", "stage stages phase phases loadstep loadsteps cycles hold", "not supported: one monotonic pull",
     leave_out},
    {"*", "body bodies pile foundation footing wall rigidbody geogrid beam", one_plate, "write [anchor]"},
    {"*", "plate", "it goes by another name", "write [anchor]"},
    {"*", "internallength characteristiclength nonlocal regularization",
     "not supported: strain is local, bands are as wide as a cell", leave_out},
    {"*", "interface rinter", "it goes by another name", "write anchor.friction_angle"},
    {"*", "boundary boundaries boundaryconditions bc", fixed_sides, leave_out},
    {"*",
     "hardening softening hardeningsoil hssmall hypoplastic hypoplasticity camclay modifiedcamclay "
     "druckerprager norsand sanisand ubcsand muirheadwood critical",
     laws, leave_out},
    {"*", "hardeningmodulus hardeningparameter", laws, leave_out},
    {"*", "earthquake acceleration seismic basemotion", "not supported: quasi-static pulls", leave_out},
    {"*", "temperature thermal", "not supported: nothing is thermal here", leave_out},
    {"*", "mesh grid elements nodes tartan refinement", grid, "write domain.cell"},
    {"*", "material materials soil sand",
     "its keys stand in [grains] (rve) or [continuum] (closed-form laws)", "write [grains] or [continuum]"},
    {"*", "materialpoints particles", "they fill the ground by themselves", "write domain.points_per_cell"},
    {"*", "analysis calculation solver simulation", "its keys stand in other tables",
     "write [anchor] pull_to, [mpm], [output]"},
    {"*", "threads nthreads cores ncores openmp arch gpu device", "the machine is no part of a scene",
     "give --threads N on the command line"},
    {"*", "resume restart checkpoint", "it is a flag", "give --resume on the command line"},
    {"*", "dimension dimensions axisymmetric 3d planestrain", "not supported: plane strain only", leave_out},
    {"*", "regions probes gauges", "it goes by another name", "write [[region]] tables"},
    {"*", "include import base extends", "not supported: a scene is one file", "give what changes by --set"},
};

std::string plain(std::string_view name) {
    std::string out;
    for (const char c : name)
        if (c != '_' && c != '-' && c != ' ')
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return out;
}

bool holds(std::string_view words, std::string_view word) {
    for (std::size_t from = 0; from < words.size();) {
        const std::size_t to = std::min(words.find(' ', from), words.size());
        if (words.substr(from, to - from) == word) return true;
        from = to + 1;
    }
    return false;
}

}  // namespace

std::optional<ForeignWord> foreign_word(std::string_view table, std::string_view name) {
    const std::string word = plain(name);
    for (const Entry& entry : entries)
        if (entry.table == table && holds(entry.words, word)) return ForeignWord{entry.why, entry.advice};
    return std::nullopt;
}

}  // namespace sandgraph::scene
