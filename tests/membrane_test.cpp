// Membrane: what a sheet of springs is in the limit of a fine grid. Square cells of k along their sides and kd across
// them, border springs half as stiff, make a membrane of
//
//   W = k (exx^2 + eyy^2)/2 + kd [(exx + eyy)^2/2 + 2 exy^2]  per area:  C11 = k + kd, C12 = C66 = kd,
//
// whatever the grid: isotropic where kd = k/2, k = 3Y/4. Masses are rho h^2, border masses lighter. Stretched alike
// both ways and held at its edges it is a drum, whose motion converges with the grid at order 2.
#include "catch.hpp"
#include "physics_sheet.hpp"

using namespace drapeau;
using namespace drapeau::testing;

namespace {

constexpr double pi = 3.141592653589793;
constexpr double side = 0.9, Y = 200.0, rho = 0.11;  // m at rest, N/m, kg/m2
constexpr double k = 0.75 * Y, kd = 0.5 * k, longer = 1.1;

/// The drum on N x N cells: masses rho h^2, or the whole cloth's mass shared out among all masses alike.
Model drum(int N, bool shared_out = false) {
    const double m = rho * side * side / (shared_out ? (N + 1.0) * (N + 1.0) : 1.0 * N * N);
    return Model(spread(N + 1, N + 1, side, side), {m, k, kd, {}}, Attach::edges, {}, {}, Borders::light);
}
/// Stretched, and out of its plane by half a sine wave each way, `height` (m) high.
Points raised(const Model& model, double height) {
    const int N = model.grid.columns - 1;
    auto x = scattered(model.grid, 0.0);
    for (int n = 0; n < masses_of(model); ++n) {
        x[n] *= longer;
        if (!is_held(model, n)) x[n].z = height * std::sin(pi * (n % (N + 1)) / N) * std::sin(pi * (n / (N + 1)) / N);
    }
    return x;
}
/// A share of the time (s) that a wave along the cloth takes from mass to mass, such that a whole number of steps last
/// `seconds`.
struct Steps {
    long long count;
    double dt;

    Steps(int N, double share, double seconds)
        : count(static_cast<long long>(std::ceil(seconds * N * std::sqrt(9.0 * Y / (8.0 * rho)) / (share * side)))),
          dt(seconds / static_cast<double>(count)) {}
};

/// Where the masses of the drum are 0.05 s after it is let go from 50 mm.
template <class Method>
Points drummed(int N, double share, bool shared_out = false) {
    const Model model = drum(N, shared_out);
    Sheet<double, Method> sheet(model, raised(model, 0.05), at_rest(model));
    const Steps steps(N, share, 0.05);
    sheet.advance(steps.dt, steps.count);
    return sheet.positions();
}

/// Root mean squares of the coordinates by which the 5 x 5 masses that all grids have in common differ between grids of
/// 4, 8... 64 cells a side, each from the next.
template <class Method>
std::vector<double> differences(double share, bool shared_out = false) {
    std::vector<double> all;
    auto coarse = drummed<Method>(4, share, shared_out);
    for (int N = 4; N < 64; N *= 2) {
        auto fine = drummed<Method>(2 * N, share, shared_out);
        Points off;
        for (int j = 0; j <= N; j += N / 4)
            for (int i = 0; i <= N; i += N / 4)
                off.push_back(coarse[j * (N + 1) + i] - fine[2 * j * (2 * N + 1) + 2 * i]);
        all.push_back(root_mean_square(off) / std::sqrt(3.0));
        coarse = std::move(fine);
    }
    return all;
}
std::vector<double> orders(const std::vector<double>& errors) {
    std::vector<double> all;
    for (std::size_t n = 0; n + 1 < errors.size(); ++n) all.push_back(std::log2(errors[n] / errors[n + 1]));
    return all;
}

}  // namespace

TEST_CASE("Strained alike everywhere a sheet holds the energy of its membrane, whatever the grid", "[physics]") {
    // Of cells a x b with the diagonal d: C11 = k a/b + 2kd a^3/(b d^2), C22 likewise, C12 = C66 = 2kd ab/d^2.
    const double stiffness = 80.0, across = 30.0, size = 1e-5;
    for (const Grid& grid : {Grid{2, 2, 0.1, 0.1}, Grid{8, 5, 0.03, 0.03}, Grid{7, 6, 0.1, 0.08}})
        for (const auto& [xx, yy, xy] :
             {std::tuple{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, -0.3, 0.0}, {0.5, 0.7, -0.4}}) {
            const Model model(grid, {0.01, stiffness, across, {}}, Attach::none, {}, {}, Borders::light);
            auto x = scattered(grid, 0.0);
            for (auto& p : x) p += size * glm::dvec3{xx * p.x + xy * p.y, xy * p.x + yy * p.y, 0.0};
            Sheet<double, SemiImplicitEuler> sheet(model, x, at_rest(model));
            const double a = grid.pitch_x, b = grid.pitch_y, dd = a * a + b * b;
            const double C11 = stiffness * a / b + 2.0 * across * a * a * a / (b * dd);
            const double C22 = stiffness * b / a + 2.0 * across * b * b * b / (a * dd);
            const double C12 = 2.0 * across * a * b / dd;
            if (a == b) CHECK(C11 == Approx(stiffness + across));
            if (a == b) CHECK(C12 == Approx(across));
            const double W = 0.5 * (C11 * xx * xx + C22 * yy * yy) + C12 * (xx * yy + 2.0 * xy * xy);
            const double area = (grid.columns - 1) * a * (grid.rows - 1) * b;
            // Strains are known to `size` of themselves, and lengths to eps of themselves, 1/size times that of what
            // they are longer by.
            CHECK(sheet.measure().elastic == Approx(size * size * W * area).epsilon(4.0 * size));
        }
}

TEST_CASE("A drum's large swing converges with the grid at order 2", "[physics]") {
    // By how much grids differ is what an independent program found, to the three digits given. Leapfrog's steps shrink
    // with the grid: both its error and the grid's are of order 2. Runge-Kutta's own is nothing beside the grid's.
    const auto by_leapfrog = differences<Leapfrog>(0.2);
    const double found[] = {1.29e-3, 3.98e-4, 1.14e-4, 2.78e-5};  // m
    for (int n = 0; n < 4; ++n) CHECK(by_leapfrog[n] == Approx(found[n]).epsilon(0.005));
    const double climbing[] = {1.70, 1.81, 2.03};
    for (int n = 0; n < 3; ++n) CHECK(orders(by_leapfrog)[n] == Approx(climbing[n]).margin(0.01));
    CHECK(orders(differences<Rk4>(0.8)).back() == Approx(2.0).margin(0.1));
}

TEST_CASE("A drum whose mass is shared out among all masses alike converges at order 1 only", "[physics]") {
    // As if its border, which does not move, weighed as much as the rest: too light by (N/(N + 1))^2.
    const double climbing[] = {0.52, 0.91, 1.00};
    const auto measured = orders(differences<Leapfrog>(0.2, true));
    for (int n = 0; n < 3; ++n) CHECK(measured[n] == Approx(climbing[n]).margin(0.01));
}

TEST_CASE("A drum's small swing has its lattice's frequency, which converges to the membrane's at order 2",
          "[physics]") {
    const double share = 1.0 - 1.0 / longer;
    const double membrane = std::sqrt((k + 2.0 * kd) * share / rho) * pi * std::sqrt(2.0) / side;
    CHECK(membrane == Approx(77.7303).epsilon(1e-6));
    const double found[] = {72.922, 76.493, 77.419, 77.652, 77.711};  // 1/s, by an independent program
    std::vector<double> errors;
    for (int n = 0; n < 5; ++n) {
        const int N = 4 << n;
        const Model model = drum(N);
        const auto x = raised(model, 1e-8);
        Sheet<double, Leapfrog> sheet(model, x, at_rest(model));
        const Steps steps(N, 0.5, 0.4 * pi / membrane);  // a fifth of a swing: its height falls fast
        sheet.advance(steps.dt, steps.count);
        const auto now = sheet.positions();
        double left = 0.0, whole = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) left += x[i].z * now[i].z, whole += x[i].z * x[i].z;
        // Leapfrog swings with cos(w dt) = 1 - (omega dt)^2/2.
        const double theta = std::acos(left / whole) / static_cast<double>(steps.count);
        const double omega = 2.0 * std::sin(0.5 * theta) / steps.dt;
        const double P = std::cos(pi / N), m = model.springs.mass;
        // Tension is known to 11 times the eps of 1 m over h: 3e-14 here over 500 steps.
        CHECK(omega == Approx(std::sqrt(share * (4.0 * k * (1.0 - P) + 4.0 * kd * (1.0 - P * P)) / m)).epsilon(1e-10));
        CHECK(omega == Approx(found[n]).margin(6e-4));
        errors.push_back(membrane - omega);
    }
    for (const double order : orders(errors)) CHECK(order == Approx(2.0).margin(0.1));
}
