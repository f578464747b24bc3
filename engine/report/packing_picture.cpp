#include "report/packing_picture.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace sandgraph::report {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int sectors = 18;           // of 10 deg over half a turn
constexpr double bar_of_mean = 0.35;  // width of a bar under the mean force, in mean radii
constexpr double widest_bar = 2;      // in mean radii
constexpr double millimetre = 1e3;

using Contacts = std::vector<dem::ContactForce>;

Vec2 inside_cell(const dem::Packing& p, std::size_t k) {
    const Vec2 at(p.x[k], p.y[k]), s = p.H.inverse() * at;
    return millimetre * (at - p.H * Vec2(std::floor(s.x()), std::floor(s.y())));
}

std::string grain_rows(const dem::Packing& p) {
    std::string text;
    for (std::size_t k = 0; k < p.size(); ++k) {
        const Vec2 at = inside_cell(p, k);
        text += fmt::format("{:.4f} {:.4f} {:.4f}\n", at.x(), at.y(), millimetre * p.r[k]);
    }
    return text;
}

double mean_force(const Contacts& contacts) {
    double sum = 0;
    for (const dem::ContactForce& c : contacts) sum += c.f_n;
    return contacts.empty() ? 0 : sum / static_cast<double>(contacts.size());
}

// Polygons parted by blank lines.
std::string bar_rows(const dem::Packing& p, const Contacts& contacts) {
    double radius = 0;
    for (const double r : p.r) radius += millimetre * r / static_cast<double>(p.size());
    const double mean = mean_force(contacts);
    std::string text;
    for (const dem::ContactForce& c : contacts) {
        const auto i = static_cast<std::size_t>(c.i), j = static_cast<std::size_t>(c.j);
        const Vec2 from = inside_cell(p, i), to = from + millimetre * (p.r[i] + p.r[j] - c.overlap) * c.n;
        const double half = 0.5 * radius * std::min(widest_bar, bar_of_mean * c.f_n / mean);
        const Vec2 side = half * Vec2(-c.n.y(), c.n.x());
        for (const Vec2& corner : {Vec2(from + side), Vec2(to + side), Vec2(to - side), Vec2(from - side)})
            text += fmt::format("{:.4f} {:.4f}\n", corner.x(), corner.y());
        text += "\n";
    }
    return text;
}

// The cell about the middle of the present one.
std::string cell_rows(const Mat2& H, const Vec2& middle) {
    std::string text;
    for (const Vec2& s : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1), Vec2(0, 0)}) {
        const Vec2 at = middle + millimetre * H * (s - Vec2(0.5, 0.5));
        text += fmt::format("{:.4f} {:.4f}\n", at.x(), at.y());
    }
    return text;
}

// Share of the contacts in each sector times the number of sectors.
std::array<double, sectors> rose(const Contacts& contacts) {
    std::array<double, sectors> share{};
    for (const dem::ContactForce& c : contacts) {
        const double turn = std::atan2(c.n.y(), c.n.x()) / pi;  // -1 .. 1, in half turns
        const auto k = static_cast<int>(std::floor((turn < 0 ? turn + 1 : turn) * sectors));
        share[static_cast<std::size_t>(std::clamp(k, 0, sectors - 1))] +=
            double(sectors) / static_cast<double>(contacts.size());
    }
    return share;
}

std::string rose_rows(const Contacts& contacts) {
    const std::array<double, sectors> share = rose(contacts);
    std::string text;
    for (int k = 0; k < 2 * sectors; ++k) {
        const double r = share[static_cast<std::size_t>(k % sectors)];
        text += "0 0\n";
        for (int step = 0; step <= 4; ++step) {
            const double angle = pi * (k + step / 4.0) / sectors;
            text += fmt::format("{:.4f} {:.4f}\n", r * std::cos(angle), r * std::sin(angle));
        }
        text += "0 0\n\n";
    }
    return text;
}

struct Fabric {
    double anisotropy = 0, direction = 0;  // F_a, major principal direction [rad]
};

Fabric fabric_of(const Contacts& contacts) {
    double cosine = 0, sine = 0;
    for (const dem::ContactForce& c : contacts)
        cosine += c.n.x() * c.n.x() - c.n.y() * c.n.y(), sine += 2 * c.n.x() * c.n.y();
    const double count = std::max<double>(1, static_cast<double>(contacts.size()));
    return {2 * std::hypot(cosine, sine) / count, 0.5 * std::atan2(sine, cosine)};
}

std::string rose_script(const Fabric& fabric, double largest) {
    const double radius = std::ceil(largest * 2) / 2;
    return fmt::format(
        "reset\nset origin 0.58,0.04\nset size 0.42,0.88\nset size ratio 1\nset xrange [-{0}:{0}]\nset "
        "yrange "
        "[-{0}:{0}]\nunset border\nunset tics\nset key below\nset title 'contact directions: F_a = {1:.2f}, "
        "mostly {2:.0f} deg from x' noenhanced\nset parametric\nset trange [0:2*pi]\nplot 'rose.txt' with "
        "filledcurves closed fs solid 0.55 border rgb '#0072B2' fc rgb '#56B4E9' notitle, cos(t), sin(t) "
        "with "
        "lines dt 3 lw 1.5 lc rgb '#555555' title 'alike everywhere', "
        "(1+{3}*cos(2*(t-{4})))*cos(t), (1+{3}*cos(2*(t-{4})))*sin(t) with lines lw 2.5 lc rgb '#D55E00' "
        "title "
        "'fabric tensor'\n",
        radius, fabric.anisotropy, std::round(fabric.direction * 180 / pi) + 0.0, fabric.anisotropy,
        fabric.direction);
}

struct Extent {
    double x = 0, y = 0;  // half, about the middle [mm]
    void take(const Mat2& H) {
        x = std::max(x, 0.5 * millimetre * (std::abs(H(0, 0)) + std::abs(H(0, 1))));
        y = std::max(y, 0.5 * millimetre * (std::abs(H(1, 0)) + std::abs(H(1, 1))));
    }
};

std::string first_item(double d_over_B) {
    return ", 'first.txt' with lines dt 3 lw 2 lc rgb '#D55E00' title " +
           literal(d_over_B > 0 ? fmt::format("at d/B = {:.3g}", d_over_B) : "before the pull");
}

std::string network_script(const PackingPicture& picture, const Contacts& contacts, const Vec2& middle) {
    Extent extent;
    extent.take(picture.packing.H);
    if (picture.first_cell) extent.take(picture.first_cell->H);
    return fmt::format(
        "set origin 0,0.02\nset size 0.58,0.92\nset size ratio -1\nset xrange [{}:{}]\nset yrange "
        "[{}:{}]\nset "
        "xlabel 'x [mm]'\nset ylabel 'y [mm]'\nset tics out nomirror\nset title '{} contacts, mean normal "
        "force "
        "{:.3g} N (widest bars: {:.1f} times that, or more)' noenhanced\nset bmargin 6\nset key below\nplot "
        "'grains.txt' with circles fs solid 1.0 border rgb "
        "'#c9c2b4' fc "
        "rgb '#efe9dc' notitle, 'bars.txt' with filledcurves closed fs solid noborder fc rgb '#7a1f1f' "
        "notitle, "
        "'cell.txt' with lines lw 2 lc rgb 'black' title 'periodic cell'{}\n",
        middle.x() - 1.1 * extent.x, middle.x() + 1.1 * extent.x, middle.y() - 1.1 * extent.y,
        middle.y() + 1.1 * extent.y, contacts.size(), mean_force(contacts), widest_bar / bar_of_mean,
        picture.first_cell ? first_item(picture.first_cell->d_over_B) : "");
}

}  // namespace

Plot packing_plot(const PackingPicture& picture) {
    const dem::Packing& p = picture.packing;
    const Contacts contacts = dem::contact_forces(p, picture.material);
    const bool empty = contacts.empty();  // a packing that floats
    const Vec2 middle = millimetre * p.H * Vec2(0.5, 0.5);
    Plot plot;
    plot.width = 1300, plot.height = 700;
    plot.data = {{"grains.txt", grain_rows(p)},
                 {"bars.txt", empty ? "0 0\n" : bar_rows(p, contacts)},
                 {"cell.txt", cell_rows(p.H, middle)},
                 {"rose.txt", empty ? "0 0\n" : rose_rows(contacts)}};
    if (picture.first_cell) plot.data.emplace_back("first.txt", cell_rows(picture.first_cell->H, middle));
    double largest = 1.5;
    if (!empty)
        for (const double share : rose(contacts)) largest = std::max(largest, share);
    plot.script = fmt::format("set multiplot title {} noenhanced\n", wrapped(picture.title, plot.width)) +
                  network_script(picture, contacts, middle) + rose_script(fabric_of(contacts), largest) +
                  "unset multiplot\n";
    return plot;
}

Picture draw_packing_picture(const PackingPicture& picture, const std::filesystem::path& png) {
    return draw(packing_plot(picture), png);
}

}  // namespace sandgraph::report
