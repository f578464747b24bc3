#include "report/sweep_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/text.hpp"
#include "io/atomic_file.hpp"
#include "report/html.hpp"

namespace sandgraph::report {
namespace {

namespace fs = std::filesystem;
using results::SweepRowResult;
using results::SweepSample;
using simulation::SweepPlan;

std::string title_of(const SweepPlan& plan) {
    const std::string& title = plan.table.spec.title;
    return title.empty() ? fs::path(plan.table.spec.file).stem().string() : title;
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

std::string first_value(const SweepPlan& plan, std::size_t row) {
    return plan.table.axes.empty() ? "" : plan.table.rows[row].values[plan.table.axes.front()].text;
}

// "2" and "30 deg" are numbers on an axis, "dense" is none.
bool is_number(const std::string& text) {
    char* end = nullptr;
    return std::isfinite(std::strtod(text.c_str(), &end)) && end != text.c_str();
}

// What tells the row from others at the same place of the first axis.
std::string label_of(const SweepPlan& plan, std::size_t row) {
    std::string label;
    for (std::size_t a = 1; a < plan.table.axes.size(); ++a) {
        const std::size_t key = plan.table.axes[a];
        const std::string& value = plan.table.rows[row].values[key].text;
        label += fmt::format("{}{}", label.empty() ? "" : ", ",
                             is_number(value) ? last_part(plan.table.keys[key]) + " " + value : value);
    }
    return label.empty() ? "N" : label;
}

// "embedment_ratio", "friction_angle [deg]": the unit as the first value has it.
std::string axis_of(const SweepPlan& plan) {
    if (plan.table.axes.empty()) return "";
    const std::string value = first_value(plan, 0), key = plan.table.keys[plan.table.axes.front()];
    const std::size_t blank = value.find(' ');
    return is_number(value) && blank != std::string::npos
               ? fmt::format("{} [{}]", key, value.substr(blank + 1))
               : key;
}

// The numbers of the axis, or the places of its words.
class Axis {
  public:
    explicit Axis(const SweepPlan& plan) {
        for (std::size_t k = 0; k < plan.table.rows.size(); ++k) {
            const std::string value = first_value(plan, k);
            numbers_ = numbers_ && is_number(value);
            if (std::ranges::find(words_, value) == words_.end()) words_.push_back(value);
        }
    }
    double at(const std::string& value) const {
        if (numbers_) return std::strtod(value.c_str(), nullptr);
        return static_cast<double>(std::ranges::find(words_, value) - words_.begin());
    }
    std::vector<std::string> places() const { return numbers_ ? std::vector<std::string>{} : words_; }

  private:
    bool numbers_ = true;
    std::vector<std::string> words_;
};

SweepPicture::Curve& curve_of(SweepPicture& picture, const std::string& label) {
    const auto found = std::ranges::find(picture.curves, label, &SweepPicture::Curve::label);
    if (found != picture.curves.end()) return *found;
    return picture.curves.emplace_back(SweepPicture::Curve{label, {}});
}

std::string number(double value, int decimals) {
    return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string factor(const SweepRowResult& r) {
    return number(r.n_gamma.mean, 3) +
           (std::isfinite(r.n_gamma.ci95) ? fmt::format(" ± {:.3f}", r.n_gamma.ci95) : "");
}

std::string percent(double share) {
    return std::isfinite(share) ? fmt::format("{:.1f} %", 100 * share) : "-";
}

std::string table_of(const SweepPlan& plan, const std::vector<SweepRowResult>& rows) {
    std::vector<Row> cells(1, Row{"row"});
    std::vector<std::string> links{""};
    for (const std::string& key : plan.table.keys) cells[0].push_back(key);
    for (const char* name : {"finished", "N_gamma", "deviation", "5, 50, 95 %", "closed form", "peak [kN/m]",
                             "at d/B", "late [kN/m]", "warnings", "audit", "cost [s]", "status"})
        cells[0].emplace_back(name);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const SweepRowResult& r = rows[k];
        const scene::SweepRow& row = plan.table.rows[k];
        Row line{row.name};
        for (const scene::SweepValue& value : row.values) line.push_back(value.text);
        const std::string spread = r.n_gamma.count > 1 ? fmt::format("{:.3f} {:.3f} {:.3f}", r.quantiles[0],
                                                                     r.quantiles[1], r.quantiles[2])
                                                       : "-";
        for (const std::string& text :
             {fmt::format("{} of {}", r.finished, r.samples.size()), factor(r),
              number(r.n_gamma.deviation, 3), spread, number(r.formula, 3), number(r.peak / 1000, 2),
              number(r.d_over_B, 4), number(r.late / 1000, 2), std::to_string(r.warnings),
              percent(r.audit_error), number(r.cpu, 0), std::string(results::state_word(r.state))})
            line.push_back(text);
        cells.push_back(std::move(line));
        links.push_back(link_to(row.name));
    }
    return table(cells, true, links);
}

Row sample_row(const SweepSample& s) {
    const io::Summary none, &m = s.summary ? *s.summary : none;
    return {std::to_string(s.run->sample),
            results::state_word(s.state),
            number(s.summary && m.breakout ? m.n_gamma : NAN, 3),
            number(m.breakout_load / 1000, 2),
            number(m.breakout_d_over_B, 4),
            number(m.cpu_s, 0),
            s.failure};
}

// A row's runs, each a link to its folder.
std::string chapter_of(const SweepPlan& plan, const SweepRowResult& r) {
    const std::string& name = plan.table.rows[r.samples.front().run->row].name;
    std::vector<Row> cells{{"sample", "status", "N_gamma", "peak [kN/m]", "at d/B", "cost [s]", "failure"}};
    std::vector<std::string> links{""};
    for (const SweepSample& s : r.samples) {
        cells.push_back(sample_row(s));
        links.push_back(fmt::format("rows/{}/{}/", name, s.run->sample));
    }
    std::string html =
        fmt::format("<h3 id=\"{0}\">{0}</h3>\n", xml_escaped(name)) + table(cells, true, links);
    for (const SweepSample& s : r.samples)
        if (s.summary)
            for (const std::string& warning : s.summary->warnings)
                html += fmt::format("<p>sample {}: {}</p>\n", s.run->sample, xml_escaped(warning));
    return html;
}

fs::path histogram_of(const SweepPlan& plan, std::size_t row) {
    return plan.folder / fmt::format("histogram_{}.png", plan.table.rows[row].name);
}

// An older picture would pass for this one's if none can be drawn.
void draw_or_tell(const Plot& plot, const fs::path& png, std::string& told) {
    fs::remove(png);
    if (const Picture drawn = draw(plot, png); !drawn.drawn) told = drawn.message;
}

}  // namespace

SweepPicture sweep_picture(const SweepPlan& plan, const std::vector<SweepRowResult>& rows) {
    const Axis axis(plan);
    SweepPicture picture{title_of(plan), axis_of(plan), axis.places(), {}};
    for (std::size_t k = 0; k < rows.size(); ++k)
        curve_of(picture, label_of(plan, k))
            .marks.push_back(
                {axis.at(first_value(plan, k)), rows[k].n_gamma.mean, rows[k].n_gamma.ci95, rows[k].formula});
    for (SweepPicture::Curve& curve : picture.curves)
        std::ranges::stable_sort(curve.marks, {}, &SweepPicture::Mark::at);
    return picture;
}

std::string write_sweep_page(const SweepPlan& plan, const std::vector<SweepRowResult>& rows) {
    std::string told;
    const bool any = std::ranges::any_of(rows, [](const SweepRowResult& r) { return r.n_gamma.count > 0; });
    std::string body = fmt::format("<h1>{}</h1>\n<p class=\"lead\">{} rows, {} runs of {}</p>\n",
                                   xml_escaped(title_of(plan)), rows.size(), plan.runs.size(),
                                   xml_escaped(plan.table.spec.scene));
    if (any) draw_or_tell(sweep_plot(sweep_picture(plan, rows)), plan.folder / "chart.png", told);
    body +=
        any ? figure(plan.folder / "chart.png",
                     "Breakout factor; bars: 95 % interval of the mean over the samples; broken: closed form")
            : "<p>No run has broken out yet.</p>\n";
    body += table_of(plan, rows) + "<h2>Rows</h2>\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        body += chapter_of(plan, rows[k]);
        if (rows[k].n_gamma.count < histogram_from) continue;
        draw_or_tell(histogram_plot({plan.table.rows[k].name, rows[k].factors()}), histogram_of(plan, k),
                     told);
        body += figure(histogram_of(plan, k), "Breakout factors of " + plan.table.rows[k].name);
    }
    io::write_text(plan.folder / "index.html", page(title_of(plan), body));
    return told;
}

}  // namespace sandgraph::report
