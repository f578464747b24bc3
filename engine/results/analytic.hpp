#pragma once

// Closed-form breakout factors N_gamma = Q_u/(B gamma H) of strip anchors in cohesionless soil. Angles in
// rad.
namespace sandgraph::results {

inline constexpr double nominal_uplift_coefficient = 0.95;  // K_u, strip anchor (Meyerhof & Adams 1968)

// Critical embedment ratio H_cr/B of Table 1 of Meyerhof & Adams (1968): 2.5, 3, 4, 5, 7, 9 at phi = 20, 25,
// 30, 35, 40, 45 deg; linear in between, constant beyond. The table was made for circular footings.
double critical_embedment_table(double friction_angle);

// H_cr/B used by default: the table's, but at least 5. All worked values that go with Liang et al. (2021)
// (phi = 30.2 and 20.9 deg at H/B = 3 and 5) lie on the shallow branch although the table gives 4.04
// and 2.59; and their Fig. 4 shows the slope of a strip in dense sand to drop past H/B = 5. A strip's surface
// reaches deeper than a circle's (Das & Jones 1982 measured about 1.4 times).
double critical_embedment(double friction_angle);

// Horizontal plate pulled up, Meyerhof & Adams (1968), eqs. 19 and 20 of Liang et al. (2021):
// N = (H/B) K_u tan(phi) + 1 for H <= H_cr; N = (2 - H_cr/H) (H_cr/B) K_u tan(phi) + 1 deeper.
double meyerhof_adams(double embedment_ratio, double friction_angle);
double meyerhof_adams(double embedment_ratio, double friction_angle, double critical_ratio);

// The same for a rough plate `thickness` thick: the sand beside its ends is dragged along, so that the block
// starts from the lower corners, N = 1 + K_u tan(phi) (H + t)^2 / (H B). NaN on the deep branch, which has no
// such block.
double meyerhof_adams_thick(double embedment_ratio, double thickness_ratio, double friction_angle);

// Horizontal plate pulled up out of sand that dilates by less than it rubs, limit equilibrium with the stress
// on the slip planes that there is at rest (White, Cheuk & Bolton 2008, Geotechnique 58(10), 771-779):
// N = 1 + (H/B) [tan psi + (tan phi - tan psi) ((1 + K0)/2 - (1 - K0) cos(2 psi)/2)].
double white_cheuk_bolton(double embedment_ratio, double friction_angle, double dilation_angle, double k0);

// Vertical plate pulled sideways, Biarez et al. (1965), eq. 21: N = 4 pi (1 - B/H) tan(phi); zero for H <= B.
double biarez(double embedment_ratio, double friction_angle);

double rankine_active(double friction_angle);   // K_a = tan^2(pi/4 - phi/2)
double rankine_passive(double friction_angle);  // K_p = tan^2(pi/4 + phi/2)

}  // namespace sandgraph::results
