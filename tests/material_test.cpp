// Material: springs become a fabric and a fabric springs, and the flag stays what it was as far as it can.
#include "catch.hpp"
#include "scene/check.hpp"
#include "scene/file.hpp"
#include "scene/material.hpp"

using namespace drapeau;

namespace {

/// 31 x 21 masses on cells a x 50 mm.
Scene scene_of(double a) {
    Scene scene;
    scene.flag.columns = 31, scene.flag.rows = 21;
    scene.flag.width = 30.0 * a, scene.flag.height = 1.0;
    scene.springs = SpringSettings{2e-4, 300.0, 40.0, 0.003, 7e-4, {}};
    return scene;
}

}  // namespace

TEST_CASE("springs that become a fabric weigh, pull and brake as before inside the cloth") {
    const Scene springs = scene_of(0.05);
    Scene fabric = springs;
    give_as_fabric(fabric);
    REQUIRE(fabric.fabric);
    CHECK_FALSE(fabric.springs);
    CHECK_FALSE(find_fault(fabric));
    const Model was = model_of(springs), is = model_of(fabric);
    CHECK(is.springs.mass == Approx(was.springs.mass));
    CHECK(is.springs.stiffness == Approx(was.springs.stiffness));
    CHECK(is.springs.along_hoist == Approx(1.0));
    CHECK(*is.springs.diagonal_stiffness == Approx(*was.springs.diagonal_stiffness));
    CHECK(*is.springs.damping == Approx(*was.springs.damping));
    CHECK(is.damping_on_mass(1.0) == Approx(was.damping_on_mass(1.0)));

    // And back to the very springs, but that a damper goes with its spring's stiffness now.
    give_as_springs(fabric);
    CHECK_FALSE(fabric.fabric);
    CHECK(fabric.springs->mass == Approx(2e-4));
    CHECK(fabric.springs->stiffness == Approx(300.0));
    CHECK(*fabric.springs->diagonal_stiffness == Approx(40.0));
    CHECK(*fabric.springs->damping == Approx(0.003));
    CHECK(*fabric.springs->drag == Approx(7e-4));
}

TEST_CASE("on cells that are not square weight, diagonals and drag stay, and what is not listed stays so") {
    Scene scene = scene_of(0.06);
    give_as_fabric(scene);
    const Model model = model_of(scene);
    CHECK(model.springs.mass == Approx(2e-4));
    CHECK(*model.springs.diagonal_stiffness == Approx(40.0));
    CHECK(model.damping_on_mass(1.0) == Approx(7e-4));
    CHECK(model.springs.along_hoist > 1.0);  // cells longer along the fly: their springs stand for less cloth across
    give_as_springs(scene);
    CHECK(scene.springs->stiffness == Approx(model.springs.stiffness * std::sqrt(model.springs.along_hoist)));

    Scene bare = scene_of(0.06);
    bare.springs = SpringSettings{2e-4, 300.0, {}, {}, {}, {}};
    give_as_fabric(bare);
    CHECK_FALSE(bare.fabric->diagonal_share);
    CHECK_FALSE(bare.fabric->damping_time);
    CHECK_FALSE(bare.fabric->drag_per_area);
    CHECK(bare.fabric->stretch_modulus == Approx(300.0));
}

TEST_CASE("a flag whose cells no fabric of these springs can have is given other rows, and a chain is refused") {
    Scene scene = scene_of(0.2);  // four times as long as wide
    scene.springs->diagonal_stiffness = 150.0;
    give_as_fabric(scene);
    CHECK(do_cells_fit(scene));
    CHECK(scene.flag.columns == 31);
    CHECK(scene.flag.rows < 21);
    CHECK_FALSE(find_fault(scene));

    Scene chain = read_scene(find_scene("spring"));
    give_as_fabric(chain);
    REQUIRE(find_fault(chain));
    INFO(find_fault(chain)->text());
    CHECK(find_fault(chain)->text().find("a fabric has two rows and columns at least") != std::string::npos);
}
