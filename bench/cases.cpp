#include "cases.hpp"

#include "scene/file.hpp"

#include <algorithm>
#include <span>

namespace drapeau::bench {
namespace {

struct Size {
    int columns, rows;

    bool operator==(const Size&) const = default;
    long long masses() const { return 1LL * columns * rows; }
};
constexpr Size sizes[] = {{16, 16},   {32, 32},   {45, 30},     {64, 64},    {128, 128},
                          {256, 256}, {512, 512}, {1024, 1024}, {2048, 2048}};
constexpr Size two_sizes[] = {{64, 64}, {256, 256}};
constexpr Size faces_sizes[] = {{45, 30}, {128, 128}};
constexpr Size watched_sizes[] = {{12, 8}, {45, 30}, {128, 128}, {512, 512}};
constexpr Precision precisions[] = {Precision::single_precision, Precision::double_precision};

constexpr Listing all;
constexpr Listing no_diagonals{.diagonal = false};
constexpr Listing no_damping{.damping = false};
constexpr Listing no_wind{.wind = Blowing::still};
constexpr Listing no_drag{.drag = false, .wind = Blowing::still};  // wind is felt through drag
constexpr Listing springs_alone{.gravity = false, .drag = false, .wind = Blowing::still};
constexpr Listing limit{.limit = true};
constexpr Listing faces{.drag = false, .faces = true};
constexpr Listing faces_travelling{.drag = false, .wind = Blowing::travelling_x, .faces = true};
constexpr Listing bent{.bending = true};
constexpr Listing touching{.contacts = true};
constexpr Listing travelling_x{.wind = Blowing::travelling_x};
constexpr Listing travelling_xy{.wind = Blowing::travelling_xy};

bool is_one_of(const Size& size, std::span<const Size> some) {
    return std::find(some.begin(), some.end(), size) != some.end();
}

/// Methods that keep nothing besides position and velocity are timed on every grid, the others on two.
bool is_timed(Method method, const Size& size) {
    const bool keeps_little =
        with_method(method, [](const auto& m) { return std::decay_t<decltype(m)>::template fields<true> == 2; });
    return keeps_little || is_one_of(size, two_sizes);
}

}  // namespace

std::vector<std::string> Listing::names() const {
    std::vector<std::string> names{"structural"};
    if (diagonal) names.push_back("diagonal");
    if (damping) names.push_back("damping");
    if (gravity) names.push_back("gravity");
    if (drag) names.push_back("drag");
    if (wind != Blowing::still) names.push_back("wind");
    if (limit) names.push_back("limit");
    if (faces) names.push_back("air on faces");
    if (bending) names.push_back("bending");
    if (contacts) names.push_back("ground and pole");
    return names;
}

std::string Listing::label() const {
    std::string label;
    const auto add = [&](bool there, const char* part) {
        if (there) label += (label.empty() ? "" : "-") + std::string(part);
    };
    const bool still = wind == Blowing::still;
    const bool dragless = !drag && !faces;
    add(!diagonal || !damping || !gravity || dragless || still, "no");
    add(!diagonal, "diagonals");
    add(!damping, "damping");
    add(!gravity, "gravity");
    add(dragless, "drag");
    add(still, "wind");
    add(limit, "limit");
    add(faces, "air");
    add(bending, "bending");
    add(contacts, "contacts");
    add(wind == Blowing::travelling_x, "travelling");
    add(wind == Blowing::travelling_xy, "travelling-down");
    return label.empty() ? "all" : label;
}

const char* name_of(Work work) {
    switch (work) {
        case Work::step:
            return "step";
        case Work::watched:
            return "watched";
        case Work::accounted:
            return "accounted";
        case Work::measure:
            return "measure";
        case Work::terms:
            return "terms";
        case Work::mode:
            return "mode";
        case Work::forces:
            return "forces";
        case Work::snapshot:
            return "snapshot";
        case Work::copy:
            return "copy";
        case Work::report:
            break;
    }
    return "report";
}

bool takes_steps(Work work) {
    return work == Work::step || work == Work::watched || work == Work::accounted || work == Work::terms ||
           work == Work::report;
}

std::string Case::name() const {
    return std::string(name_of(work)) + "/" + std::to_string(columns) + "x" + std::to_string(rows) + "/" +
           std::string(drapeau::name_of(method)) + "/" + std::string(drapeau::name_of(precision)) +
           "/threads:" + std::to_string(threads) + "/" + listing.label();
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    const auto add = [&](Work work, const Size& size, Precision precision, const Listing& listing = all) {
        cases.push_back(
            {.work = work, .columns = size.columns, .rows = size.rows, .precision = precision, .listing = listing});
    };
    for (const Size& size : sizes)
        for (const Precision precision : precisions) {
            for (int method = 0; method < static_cast<int>(method_count); ++method)
                for (const int threads : {1, 2})
                    if (is_timed(Method{method}, size))
                        cases.push_back({.work = Work::step,
                                         .columns = size.columns,
                                         .rows = size.rows,
                                         .method = Method{method},
                                         .precision = precision,
                                         .threads = threads});
            if (size.masses() >= 45 * 30 && size.masses() <= 512 * 512)
                for (const Listing& listing : {no_diagonals, no_damping}) add(Work::step, size, precision, listing);
            if (is_one_of(size, two_sizes))
                for (const Listing& listing : {limit, travelling_x, travelling_xy})
                    add(Work::step, size, precision, listing);
            if (is_one_of(size, faces_sizes))
                for (const Listing& listing : {faces, faces_travelling, bent, touching})
                    add(Work::step, size, precision, listing);
        }
    for (const Work work : {Work::watched, Work::accounted, Work::measure, Work::mode})
        for (const Size& size : watched_sizes)
            for (const Precision precision : precisions) add(work, size, precision);
    for (const Size& size : two_sizes)
        for (const Precision precision : precisions)
            for (const Listing& listing : {all, no_damping, no_diagonals, no_wind, no_drag, springs_alone})
                add(Work::terms, size, precision, listing);
    for (const Work work : {Work::forces, Work::snapshot, Work::copy, Work::report})
        for (const Size& size : sizes)
            for (const Precision precision : precisions) add(work, size, precision);
    return cases;
}

Scene scene_of(const Case& c) {
    constexpr double pitch = 1.5 / 44.0;
    const Listing& listing = c.listing;
    Scene scene;
    scene.flag.columns = c.columns;
    scene.flag.rows = c.rows;
    scene.flag.width = pitch * (c.columns - 1);
    scene.flag.height = pitch * (c.rows - 1);
    scene.springs->mass = 1e-4;
    scene.springs->stiffness = 200.0;
    if (listing.diagonal) scene.springs->diagonal_stiffness = 100.0;
    if (listing.damping) scene.springs->damping = 0.002;
    if (listing.drag) scene.springs->drag = 6e-4;
    if (listing.gravity) scene.terms.add(Gravity{});
    switch (listing.wind) {
        case Blowing::still:
            break;
        case Blowing::steady:
            scene.terms.add(Wind{.velocity = {6.0, 0.0, 0.0}});
            break;
        case Blowing::travelling_x:
            scene.terms.add(Wind{.velocity = {6.0, 0.0, 0.0}, .gusts = {1.0, 0.0, 1.0}, .travelling = true});
            break;
        case Blowing::travelling_xy:
            scene.terms.add(Wind{.velocity = {6.0, -1.0, 0.0}, .gusts = {1.0, 0.0, 1.0}, .travelling = true});
            break;
    }
    if (listing.faces) scene.terms.add(drapeau::Air{});
    if (listing.bending) scene.terms.add(Bending{.damping = 200.0});
    if (listing.contacts) scene.limits.add(Ground{.height = -1.1 * scene.flag.height}).add(Pole{});
    if (listing.limit) scene.limits.add(StretchLimit{.stretch = 0.5});
    scene.time.method = c.method;
    scene.time.precision = c.precision;
    return scene;
}

}  // namespace drapeau::bench
