// Lattice modes: the frequencies at which a sheet swings a little, in closed form on any grid. With P = cos(theta),
// Q = cos(phi), theta = p pi/N_x and phi = q pi/N_y for half waves p and q over N_x and N_y cells of square pitch:
//
//   across a sheet stretched alike both ways, lengths l over rest lengths L, its edges held:
//     m omega^2 = (1 - L/l) [2k (2 - P - Q) + 4kd (1 - PQ)],                z = A sin(theta i) sin(phi j)
//   in the plane of a sheet at rest, on rollers: walls that its edges slide along, its borders light:
//     m omega^2 = k (2 - P - Q) + 2kd (1 - PQ) +- sqrt(k^2 (P - Q)^2 + 4 kd^2 (1 - P^2) (1 - Q^2)),
//     u_x = A sin(theta i) cos(phi j),  u_y = B cos(theta i) sin(phi j)
//
// Each mode is set, moved by the method, and every mass compared with the method's own motion of that one oscillator.
#include "catch.hpp"
#include "closed_forms.hpp"

#include <algorithm>

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double pi = 3.141592653589793;
constexpr int cells_x = 5, cells_y = 4;
constexpr double h = 0.1, m = 0.02, k = 100.0;

/// omega dt of the fastest mode. Forward Euler lets it grow by (1 + 0.05^2)^(1/2) a step: 1.05 in 40 steps.
template <class Method>
constexpr double omega_dt = std::is_same_v<Method, ForwardEuler> ? 0.05 : 0.7;

/// A mode of the roller box: its stiffness m omega^2 (N/m) and its shape.
struct RollerMode {
    int p, q;
    double stiffness, across, down;  // A, B: rows follow each other downwards

    double theta() const { return p * pi / cells_x; }
    double phi() const { return q * pi / cells_y; }
    glm::dvec3 at(int i, int j) const {
        return {across * std::sin(theta() * i) * std::cos(phi() * j),
                -down * std::cos(theta() * i) * std::sin(phi() * j), 0.0};
    }
};

/// All modes that move anything, the slowest first.
std::vector<RollerMode> roller_modes(double kd) {
    std::vector<RollerMode> modes;
    for (int p = 0; p <= cells_x; ++p)
        for (int q = 0; q <= cells_y; ++q) {
            const bool moves_x = p > 0 && p<cells_x, moves_y = q> 0 && q < cells_y;
            const double P = std::cos(p * pi / cells_x), Q = std::cos(q * pi / cells_y);
            const double xx = 2.0 * k * (1.0 - P) + 2.0 * kd * (1.0 - P * Q);
            const double yy = 2.0 * k * (1.0 - Q) + 2.0 * kd * (1.0 - P * Q);
            const double xy = 2.0 * kd * std::sin(p * pi / cells_x) * std::sin(q * pi / cells_y);
            if (moves_x && moves_y) {
                const double middle = k * (2.0 - P - Q) + 2.0 * kd * (1.0 - P * Q);
                const double apart =
                    std::sqrt(k * k * (P - Q) * (P - Q) + 4.0 * kd * kd * (1.0 - P * P) * (1.0 - Q * Q));
                for (const double stiffness : {middle - apart, middle + apart}) {
                    // (xx - stiffness) A + xy B = 0
                    const double size = std::hypot(xy, stiffness - xx);
                    modes.push_back({p, q, stiffness, xy / size, (stiffness - xx) / size});
                }
            } else if (moves_x) {
                modes.push_back({p, q, xx, 1.0, 0.0});
            } else if (moves_y) {
                modes.push_back({p, q, yy, 0.0, 1.0});
            }
        }
    std::sort(modes.begin(), modes.end(), [](const auto& a, const auto& b) { return a.stiffness < b.stiffness; });
    return modes;
}

/// Takes off what carries border masses away from their walls: the sheet's left and right edges keep their x, its top
/// and bottom their y.
template <class Sheet>
void press_to_walls(Sheet& sheet) {
    auto now = sheet.checkpoint();
    for (std::size_t f = 0; f < now.fields.size(); ++f)
        for (int j = 0; j <= cells_y; ++j)
            for (int i = 0; i <= cells_x; ++i) {
                auto value = now.fields[f].at(i, j);
                const auto wall = f == 0 ? sheet.model().grid.rest(i, j) : glm::dvec3(0.0);
                if (i == 0 || i == cells_x) value.x = wall.x;
                if (j == 0 || j == cells_y) value.y = wall.y;
                now.fields[f].set(i, j, value);
            }
    sheet.stepper.restore(now);
}

}  // namespace

TEST_CASE("The roller box has as many modes as it can move ways, and those that an independent solver found",
          "[physics]") {
    const auto modes = roller_modes(50.0);
    REQUIRE(modes.size() == (cells_x - 1) * (cells_y + 1) + (cells_x + 1) * (cells_y - 1));
    const double lowest[] = {49.1872048626, 53.523313466, 66.2827148071, 70.1382999665};  // 1/s
    for (int n = 0; n < 4; ++n) CHECK(std::sqrt(modes[n].stiffness / m) == Approx(lowest[n]).epsilon(1e-11));
}

TEMPLATE_LIST_TEST_CASE("In its plane a sheet on rollers swings in lattice modes, each by itself", "[physics]",
                        SweptDouble) {
    // Methods of one evaluation a step: between two of them nothing leaves the walls.
    using Method = typename TestType::Method;
    if constexpr (Method::passes == 1)
        for (const auto& [kd, c] : {std::pair{50.0, 0.0}, {100.0, 0.0}, {100.0, 0.05}}) {  // c: as every k, or none
            const double tau = c / k;
            Springs springs{m, k, kd, {}};
            if (c > 0.0) springs.damping = c;
            const Model model({cells_x + 1, cells_y + 1, h, h}, springs, Attach::none, {}, {}, Borders::light);
            const auto modes = roller_modes(kd);
            const double dt = omega_dt<Method> / std::sqrt(modes.back().stiffness / m), size = 1e-7;
            for (const auto& mode : modes) {
                auto x = scattered(model.grid, 0.0);
                const auto flat = x;
                for (int n = 0; n < masses_of(model); ++n) x[n] += size * mode.at(n % (cells_x + 1), n / (cells_x + 1));
                Sheet<double, Method> sheet(model, x, at_rest(model));
                sheet.advance(dt, 0);
                press_to_walls(sheet);
                constexpr int steps = 40;
                double off = 0.0, grown = 1.0;
                for (int step = 1; step <= steps; ++step) {
                    sheet.advance(dt, 1);
                    press_to_walls(sheet);
                    const double at = motion(Method{}, m, mode.stiffness, tau * mode.stiffness, false, 1.0, dt, step);
                    grown = std::max(grown, std::abs(at));
                    auto expected = flat;
                    for (int n = 0; n < masses_of(model); ++n)
                        expected[n] += size * at * mode.at(n % (cells_x + 1), n / (cells_x + 1));
                    off = std::max(off, distance(sheet.positions(), expected));
                }
                INFO("p " << mode.p << ", q " << mode.q << ", omega " << std::sqrt(mode.stiffness / m) << "/s");
                // Springs turn by up to size/h = 1e-6, which changes forces by that share; kept for 40 steps of
                // omega dt <= 0.7. 28 rad of phase known to that: omega to 1e-6 of itself.
                CHECK(off < steps * (size * grown / h) * size * grown);
            }
        }
}

TEMPLATE_LIST_TEST_CASE("Across its plane a taut sheet swings in lattice modes, each by itself", "[physics]",
                        ClosedFormDouble) {
    using Method = typename TestType::Method;
    if constexpr (!std::is_same_v<Method, Xpbd>)  // solves springs one by one: no closed form
        for (const double kd : {0.0, 50.0, 100.0})
            for (const double drag : {0.0, 0.1}) {
                Springs springs{m, k, {}, {}};
                if (kd > 0.0) springs.diagonal_stiffness = kd;
                const Model model({cells_x + 1, cells_y + 1, h, h}, springs, Attach::edges, Terms().add(AirDrag{drag}));
                const double longer = 1.1, share = 1.0 - 1.0 / longer;
                const double size = 1e-6, dt = omega_dt<Method> / std::sqrt(share * (8.0 * k + 8.0 * kd) / m);
                for (int p = 1; p < cells_x; ++p)
                    for (int q = 1; q < cells_y; ++q) {
                        const double P = std::cos(p * pi / cells_x), Q = std::cos(q * pi / cells_y);
                        const double stiffness = share * (2.0 * k * (2.0 - P - Q) + 4.0 * kd * (1.0 - P * Q));
                        const auto taut = [&](double at) {
                            auto x = scattered(model.grid, 0.0);
                            for (int n = 0; n < masses_of(model); ++n) {
                                x[n] *= longer;
                                x[n].z = is_held(model, n)
                                             ? 0.0
                                             : size * at * std::sin(p * pi * (n % (cells_x + 1)) / cells_x) *
                                                   std::sin(q * pi * (n / (cells_x + 1)) / cells_y);
                            }
                            return x;
                        };
                        Sheet<double, Method> sheet(model, taut(1.0), at_rest(model));
                        double off = 0.0, grown = 1.0;
                        constexpr int steps = 40;
                        for (int step = 1; step <= steps; ++step) {
                            sheet.advance(dt, 1);
                            const double at = motion(Method{}, m, stiffness, drag, true, 1.0, dt, step);
                            grown = std::max(grown, std::abs(at));
                            const auto x = sheet.positions(), expected = taut(at);
                            for (std::size_t n = 0; n < x.size(); ++n)
                                off = std::max(off, std::abs(x[n].z - expected[n].z));
                        }
                        INFO("kd " << kd << ", drag " << drag << ", p " << p << ", q " << q);
                        // Springs lengthen by (size/h)^2, which changes forces across by 1/share = 11 times that share;
                        // positions along the plane are known to eps of 0.5 m, lengths to 5 eps of themselves, forces
                        // across to 11 times that.
                        const double forces = 11.0 * (size * size * grown * grown / (h * h) + 5.0 * epsilon<double>);
                        CHECK(off < steps * forces * size * grown);
                    }
            }
}

TEST_CASE("A sheet pressed together buckles in lattice modes, fastest at the wave of the grid and finer grids faster",
          "[physics]") {
    // L/l > 1 makes m omega^2 negative: a mode grows as cosh(sigma t), of leapfrog with cosh(s dt) = 1 + (sigma
    // dt)^2/2. Without bending stiffness the fastest is sigma^2 = 8k |1 - L/l|/m on an endless grid: no grid is fine
    // enough.
    const double stiffness = 750.0, rho = 0.11, shorter = 0.99;
    const double found[] = {235.0, 469.0, 939.0};  // 1/s, of pitches 0.1, 0.05, 0.025 m pressed by 1 %
    for (int n = 0; n < 3; ++n) {
        const double pitch = 0.1 / (1 << n), mass = rho * pitch * pitch, size = 1e-9;
        const double endless = std::sqrt(8.0 * stiffness * (1.0 / shorter - 1.0) / mass);
        CHECK(endless == Approx(found[n]).epsilon(2e-3));
        const Model model({cells_x + 1, cells_x + 1, pitch, pitch}, {mass, stiffness, 0.5 * stiffness, {}},
                          Attach::edges);
        double fastest = 0.0;
        for (int p = 1; p < cells_x; ++p) {
            const auto wave = [&](int i) { return std::sin(p * pi * i / cells_x); };
            auto x = scattered(model.grid, 0.0);
            for (int i = 0; i < masses_of(model); ++i) {
                x[i] *= shorter;
                if (!is_held(model, i)) x[i].z = size * wave(i % (cells_x + 1)) * wave(i / (cells_x + 1));
            }
            Sheet<double, Leapfrog> sheet(model, x, at_rest(model));
            const double dt = 0.01 / endless;
            const int steps = 300;  // it grows tenfold
            sheet.advance(dt, steps);
            const auto now = sheet.positions();
            double left = 0.0, whole = 0.0;
            for (std::size_t i = 0; i < x.size(); ++i) left += x[i].z * now[i].z, whole += x[i].z * x[i].z;
            const double theta = std::acosh(left / whole) / steps, sigma = 2.0 * std::sinh(0.5 * theta) / dt;
            const double P = std::cos(p * pi / cells_x);
            const double growing = (1.0 / shorter - 1.0) * stiffness * (4.0 * (1.0 - P) + 2.0 * (1.0 - P * P)) / mass;
            // Lengths are known to an eps of 0.5 m over the pitch, what they are shorter by to 100 times that.
            CHECK(sigma == Approx(std::sqrt(growing)).epsilon(1e-9));
            fastest = std::max(fastest, sigma);
        }
        // p = N - 1, the shortest wave there is: cos(pi/N) from the endless grid's.
        CHECK(fastest == Approx(endless).epsilon(0.1));
        CHECK(fastest < endless);
    }
}
