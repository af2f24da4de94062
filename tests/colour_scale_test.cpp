// Colour scales are the published ones; legends say their numbers with units.
#include "catch.hpp"

#include "viewer/colour_scale.hpp"
#include "viewer/legend.hpp"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace drapeau;

namespace {

glm::dvec3 srgb(const ColourScale& scale, double share) {
    const glm::vec3 c = colour_at(scale, float(share));
    return {as_srgb(c.x), as_srgb(c.y), as_srgb(c.z)};
}

double apart(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 d = glm::abs(a - b);
    return std::max({d.x, d.y, d.z});
}

double luminance(const glm::vec3& linear) {
    return 0.2126 * linear.x + 0.7152 * linear.y + 0.0722 * linear.z;
}

// Moreland's diverging scale, as its paper defines it: linear in Msh, the polar form of CIELAB (D65), by way of a
// middle that has no hue, to which the hues of both ends are turned so that saturation and hue change at one rate.

struct Msh {
    double m, s, h;
};

Msh msh_of(const glm::dvec3& color) {
    const auto linear = [](double c) { return double(as_linear(float(c))); };
    const double r = linear(color.x), g = linear(color.y), b = linear(color.z);
    const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
    const double x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047), y = f(0.2126 * r + 0.7152 * g + 0.0722 * b);
    const double z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
    const double l = 116.0 * y - 16.0, a = 500.0 * (x - y), bb = 200.0 * (y - z);
    const double m = std::sqrt(l * l + a * a + bb * bb);
    return {m, std::acos(l / m), std::atan2(bb, a)};
}

glm::dvec3 srgb_of(const Msh& c) {
    const double y = (c.m * std::cos(c.s) + 16.0) / 116.0, radius = c.m * std::sin(c.s);
    const auto g = [](double t) { return t > 0.206893 ? t * t * t : (t - 16.0 / 116.0) / 7.787; };
    const double X = 0.95047 * g(y + radius * std::cos(c.h) / 500.0), Y = g(y);
    const double Z = 1.08883 * g(y - radius * std::sin(c.h) / 200.0);
    const auto shown = [](double linear) { return double(as_srgb(float(std::clamp(linear, 0.0, 1.0)))); };
    return {shown(3.2406 * X - 1.5372 * Y - 0.4986 * Z), shown(-0.9689 * X + 1.8758 * Y + 0.0415 * Z),
            shown(0.0557 * X - 0.2040 * Y + 1.0570 * Z)};
}

glm::dvec3 cool_to_warm(double share) {
    const bool warm = share > 0.5;
    const glm::dvec3 end = warm ? glm::dvec3(180, 4, 38) : glm::dvec3(59, 76, 192);
    const Msh from = msh_of(end / 255.0);
    const double middle = std::max({msh_of(glm::dvec3(180, 4, 38) / 255.0).m, from.m, 88.0});
    const double turn = from.s * std::sqrt(middle * middle - from.m * from.m) / (from.m * std::sin(from.s));
    const double hue = from.h > -std::numbers::pi / 3.0 ? from.h + turn : from.h - turn;
    const double t = std::abs(2.0 * share - 1.0);  // 1 at the end
    return srgb_of({middle + t * (from.m - middle), t * from.s, hue + t * (from.h - hue)});
}

AppState flag_shown() {
    AppState app;
    app.status.columns = 9, app.status.rows = 9;
    return app;
}

}  // namespace

TEST_CASE("viridis is the published table within 2.4/255, and ever lighter") {
    // Every eighth of its 256 rows and the last (matplotlib, CC0).
    const std::vector<glm::dvec3> rows{
        {0.267004, 0.004874, 0.329415}, {0.277018, 0.050344, 0.375715}, {0.282327, 0.094955, 0.417331},
        {0.282884, 0.13592, 0.453427},  {0.278826, 0.17549, 0.483397},  {0.270595, 0.214069, 0.507052},
        {0.258965, 0.251537, 0.524736}, {0.244972, 0.287675, 0.53726},  {0.229739, 0.322361, 0.545706},
        {0.214298, 0.355619, 0.551184}, {0.19943, 0.387607, 0.554642},  {0.185556, 0.41857, 0.556753},
        {0.172719, 0.448791, 0.557885}, {0.160665, 0.47854, 0.558115},  {0.149039, 0.508051, 0.55725},
        {0.13777, 0.537492, 0.554906},  {0.127568, 0.566949, 0.550556}, {0.120565, 0.596422, 0.543611},
        {0.120638, 0.625828, 0.533488}, {0.132268, 0.655014, 0.519661}, {0.157851, 0.683765, 0.501686},
        {0.196571, 0.711827, 0.479221}, {0.24607, 0.73891, 0.452024},   {0.304148, 0.764704, 0.419943},
        {0.369214, 0.788888, 0.382914}, {0.440137, 0.811138, 0.340967}, {0.515992, 0.831158, 0.294279},
        {0.595839, 0.848717, 0.243329}, {0.678489, 0.863742, 0.189503}, {0.762373, 0.876424, 0.137064},
        {0.845561, 0.887322, 0.099702}, {0.926106, 0.89733, 0.104071},  {0.993248, 0.906157, 0.143936}};
    for (const ColourScale* scale : {&force_colours(Colours::viridis), &stretch_colours(Colours::viridis)}) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            CAPTURE(i);
            CHECK(apart(srgb(*scale, std::min(8.0 * double(i), 255.0) / 255.0), rows[i]) <= 2.4 / 255.0);
        }
        for (std::size_t i = 1; i < scale->size(); ++i) CHECK(luminance((*scale)[i]) > luminance((*scale)[i - 1]));
    }
}

TEST_CASE("stretch goes from cool to warm as Moreland defines it, within 1.7/255, grey at rest") {
    const ColourScale& scale = stretch_colours(Colours::red);
    for (int i = 0; i <= 400; ++i) {
        const double share = i / 400.0;
        CAPTURE(share);
        REQUIRE(apart(srgb(scale, share), cool_to_warm(share)) <= 1.7 / 255.0);
    }
    CHECK(apart(srgb(scale, 0.5), glm::dvec3(221.0 / 255.0)) < 0.6 / 255.0);
}

TEST_CASE("forces go from white to red in even steps of light, and beyond a scale its ends go on") {
    const ColourScale& scale = force_colours(Colours::red);
    CHECK(colour_at(scale, 0.0f) == glm::vec3(1.0f));
    const glm::vec3 red = colour_at(scale, 1.0f);
    CHECK(red.x > 0.75f);
    CHECK(red.y == 0.0f);
    for (const float share : {0.01f, 0.3f, 0.5f, 0.77f}) {
        CAPTURE(share);
        CHECK(double(colour_at(scale, share).y) == Approx(1.0 - double(share)).margin(1e-5));
    }
    CHECK(colour_at(scale, -3.0f) == scale.front());
    CHECK(colour_at(scale, 7.0f) == scale.back());
}

TEST_CASE("a legend stands for each view that needs one, its numbers with units, and says what its range follows") {
    AppState app = flag_shown();
    CHECK(legends(app).empty());
    app.status.force_scale = 0.2;
    app.status.stretch_scale = 0.05;
    app.status.speed_scale = 5.0;
    ViewSettings& view = app.scene.view;
    view.forces = view.stretch = view.velocities = true;
    const auto shown = legends(app);
    REQUIRE(shown.size() == 3);
    CHECK(shown[0].text() == "Stretch of the cloth, (l - L) / L: -5 %, 0 %, +5 %; automatic");
    CHECK(shown[1].text() == "Force of a spring, |k (l - L)|: 0 N, 0.1 N, 0.2 N; automatic");
    CHECK(shown[2].text() == "Velocity of masses, as length: 0 m/s, 2.5 m/s, 5 m/s; automatic");

    view.force_range = 3.0;
    view.stretch_range = 0.004;
    CHECK(legends(app)[0].text() == "Stretch of the cloth, (l - L) / L: -0.4 %, 0 %, +0.4 %; fixed");
    CHECK(legends(app)[1].text() == "Force of a spring, |k (l - L)|: 0 N, 1.5 N, 3 N; fixed");
    CHECK(force_end(app) == 3.0);
    CHECK(stretch_end(app) == 0.004);
    view.velocity_range = 8.0;
    CHECK(legends(app)[2].text() == "Velocity of masses, as length: 0 m/s, 4 m/s, 8 m/s; fixed");
    CHECK(speed_end(app) == 8.0);

    // What is not drawn needs no legend.
    view.cloth = false;
    CHECK(legends(app).size() == 2);
    view.cloth = true;
    app.status.rows = 1;
    CHECK(legends(app).size() == 2);
}

TEST_CASE("legends show the colours that are chosen") {
    AppState app = flag_shown();
    app.scene.view.forces = app.scene.view.stretch = true;
    for (const Colours colours : {Colours::red, Colours::viridis}) {
        app.scene.view.colours = colours;
        CHECK(legends(app)[0].colours == &stretch_colours(colours));
        CHECK(legends(app)[1].colours == &force_colours(colours));
    }
}
