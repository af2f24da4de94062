#include "cases.hpp"

#include "scene_file.hpp"

namespace drapeau::bench {
namespace {

struct Size {
    int columns, rows;
};
constexpr Size sizes[] = {{16, 16},   {32, 32},   {45, 30},     {64, 64},    {128, 128},
                          {256, 256}, {512, 512}, {1024, 1024}, {2048, 2048}};
constexpr Precision precisions[] = {Precision::single_precision, Precision::double_precision};
constexpr Method methods[] = {Method::semi_implicit_euler, Method::forward_euler};
constexpr Terms no_diagonals{.diagonal = false};
constexpr Terms no_damping{.damping = false};
constexpr Terms no_wind{.wind = false};
constexpr Terms no_drag{.drag = false, .wind = false};  // wind is felt through drag
constexpr Terms springs_alone{.gravity = false, .drag = false, .wind = false};

}  // namespace

std::vector<std::string> Terms::names() const {
    std::vector<std::string> all{"structural"};
    if (diagonal) all.push_back("diagonal");
    if (damping) all.push_back("damping");
    if (gravity) all.push_back("gravity");
    if (drag) all.push_back("drag");
    if (wind) all.push_back("wind");
    return all;
}

std::string Terms::label() const {
    std::string missing;
    if (!diagonal) missing += "-diagonals";
    if (!damping) missing += "-damping";
    if (!gravity) missing += "-gravity";
    if (!drag) missing += "-drag";
    if (!wind) missing += "-wind";
    return missing.empty() ? "all" : "no" + missing;
}

const char* name_of(Work work) {
    switch (work) {
        case Work::step:
            return "step";
        case Work::terms:
            return "terms";
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

std::string Case::name() const {
    return std::string(name_of(work)) + "/" + std::to_string(columns) + "x" + std::to_string(rows) + "/" +
           std::string(drapeau::name_of(method)) + "/" + std::string(drapeau::name_of(precision)) +
           "/threads:" + std::to_string(threads) + "/" + terms.label();
}

std::vector<Case> all_cases() {
    std::vector<Case> cases;
    const auto add = [&](Work work, const Size& size, Precision precision, const Terms& terms = {}) {
        cases.push_back(
            {.work = work, .columns = size.columns, .rows = size.rows, .precision = precision, .terms = terms});
    };
    for (const Size& size : sizes)
        for (const Precision precision : precisions) {
            for (const Method method : methods)
                for (const int threads : {1, 2})
                    cases.push_back({.work = Work::step,
                                     .columns = size.columns,
                                     .rows = size.rows,
                                     .method = method,
                                     .precision = precision,
                                     .threads = threads});
            const long long masses = static_cast<long long>(size.columns) * size.rows;
            if (masses < 45 * 30 || masses > 512 * 512) continue;
            add(Work::step, size, precision, no_diagonals);
            add(Work::step, size, precision, no_damping);
        }
    for (const Size& size : {Size{64, 64}, Size{256, 256}})
        for (const Precision precision : precisions)
            for (const Terms& terms : {Terms{}, no_damping, no_diagonals, no_wind, no_drag, springs_alone})
                add(Work::terms, size, precision, terms);
    for (const Work work : {Work::forces, Work::snapshot, Work::copy, Work::report})
        for (const Size& size : sizes)
            for (const Precision precision : precisions) add(work, size, precision);
    return cases;
}

Scene flag_scene(int columns, int rows, Method method, const Terms& terms) {
    constexpr double pitch = 1.5 / 44.0;
    Scene scene;
    scene.flag.columns = columns;
    scene.flag.rows = rows;
    scene.flag.width = pitch * (columns - 1);
    scene.flag.height = pitch * (rows - 1);
    scene.springs.mass = 1e-4;
    scene.springs.stiffness = 200.0;
    if (terms.diagonal) scene.springs.diagonal_stiffness = 100.0;
    if (terms.damping) scene.springs.damping = 0.002;
    if (terms.drag) scene.springs.drag = 6e-4;
    if (terms.gravity) scene.gravity.emplace();
    if (terms.wind) scene.wind = WindSettings{.velocity = {6.0, 0.0, 0.0}};
    scene.time.method = method;
    return scene;
}

}  // namespace drapeau::bench
