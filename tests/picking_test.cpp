// Picking and holding: the mass and the spring under the mouse are those that are seen there, in front of what they
// hide; what the hand asks of the simulation is in the plane of the mouse; the readout tells the numbers of the model.
#include "catch.hpp"

#include "viewer/camera.hpp"
#include "viewer/hand.hpp"
#include "viewer/readout.hpp"

#include <glm/geometric.hpp>

#include <cmath>

using namespace drapeau;

namespace {

const Area view{0.0f, 0.0f, 1000.0f, 700.0f};
const glm::vec2 picture(1000.0f, 700.0f);
const Framing framing{.centre = {0.75f, -0.5f, 0.0f}, .width = 2.0f, .height = 1.5f, .ground = -2.0f};

Lens lens_of(const Camera& camera) {
    return {camera.projection(framing, view, picture) * camera.view_matrix(framing, view), picture};
}
glm::vec3 forward_of(const Camera& camera) {
    return glm::normalize(camera.target(framing) - camera.eye(framing, view));
}

/// A flag of 1.5 m x 1 m with waves of this height (m) that hide parts of it from the side.
FieldBuffer<float> cloth(int columns, int rows, double wave = 0.0) {
    FieldBuffer<float> position(columns, rows);
    const Grid grid = spread(columns, rows, 1.5, 1.0);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            glm::dvec3 place = grid.rest(i, j);
            place.z = wave * std::sin(8.0 * place.x);
            position.set(i, j, place);
        }
    return position;
}

FlagSettings flag_of(int columns, int rows) {
    FlagSettings flag;
    flag.columns = columns, flag.rows = rows, flag.width = 1.5, flag.height = 1.0;
    return flag;
}

constexpr float reach = Hand::reach;

}  // namespace

TEST_CASE("the mass that is picked is the one that is seen under the mouse") {
    const auto position = cloth(16, 11);
    for (const float azimuth : {-14.0f, 40.0f, 170.0f}) {  // from behind too
        Camera camera;
        camera.azimuth = azimuth;
        const Lens lens = lens_of(camera);
        for (int j = 0; j < 11; ++j)
            for (int i = 0; i < 16; ++i) {
                const auto seen = seen_at(lens, glm::vec3(position.at(i, j)));
                REQUIRE(seen);
                const auto picked = pick(position, lens, *seen + glm::vec2(1.5f, 1.0f), reach);
                REQUIRE(picked);
                CHECK(picked->column == i);
                CHECK(picked->row == j);
            }
    }
}

TEST_CASE("of two layers under the mouse the nearer is picked") {
    auto position = cloth(16, 11);
    for (int j = 0; j < 11; ++j)  // the fly folded over the hoist, 10 cm in front of it
        for (int i = 8; i < 16; ++i) position.set(i, j, position.at(15 - i, j) + glm::dvec3(0.0, 0.0, 0.1));
    Camera front;
    front.azimuth = front.elevation = 0.0f;
    const auto middle = seen_at(lens_of(front), glm::vec3(0.4f, -0.5f, 0.1f));
    CHECK(pick(position, lens_of(front), *middle, reach)->column >= 8);
    Camera behind = front;
    behind.azimuth = 180.0f;
    const auto same = seen_at(lens_of(behind), glm::vec3(0.4f, -0.5f, 0.0f));
    CHECK(pick(position, lens_of(behind), *same, reach)->column < 8);
}

TEST_CASE("beside the cloth its border is within reach, and the sky is not") {
    const auto position = cloth(16, 11);
    const Lens lens = lens_of(Camera());
    const glm::vec2 corner = *seen_at(lens, glm::vec3(1.5f, 0.0f, 0.0f));
    const auto near = pick(position, lens, corner + glm::vec2(6.0f, -6.0f), reach);
    REQUIRE(near);
    CHECK(near->column == 15);
    CHECK(near->row == 0);
    CHECK_FALSE(pick(position, lens, corner + glm::vec2(40.0f, -40.0f), reach));
    CHECK_FALSE(pick(FieldBuffer<float>(), lens, corner, reach));
}

TEST_CASE("a chain, which has no surface, is picked by its masses") {
    const auto position = cloth(1, 9);
    const Lens lens = lens_of(Camera());
    const auto seen = seen_at(lens, glm::vec3(position.at(0, 4)));
    const auto picked = pick(position, lens, *seen + glm::vec2(5.0f, 2.0f), reach);
    REQUIRE(picked);
    CHECK(picked->row == 4);
}

TEST_CASE("where springs are shown the one under the mouse is read, and a mass where the mouse is on it") {
    const auto position = cloth(6, 5);
    const Lens lens = lens_of(Camera());
    const auto part_at = [&](glm::dvec3 place, bool springs) {
        const glm::vec2 mouse = *seen_at(lens, glm::vec3(place));
        return nearest_part(position, lens, mouse, *pick(position, lens, mouse, reach), springs, true);
    };
    const glm::dvec3 a = position.at(2, 2), right = position.at(3, 2), below = position.at(2, 3),
                     across = position.at(3, 3);
    CHECK(part_at(0.5 * (a + right), true) == Selection{2, 2, 1, 0});
    CHECK(part_at(0.5 * (a + below), true) == Selection{2, 2, 0, 1});
    CHECK(part_at(0.7 * a + 0.3 * across, true) == Selection{2, 2, 1, 1});
    CHECK(part_at(0.3 * below + 0.7 * right, true) == Selection{3, 2, -1, 1});
    CHECK(part_at(a, true) == Selection{2, 2});
    CHECK(part_at(0.55 * a + 0.45 * right, false) == Selection{2, 2});
}

TEST_CASE("a hand pulls to the mouse, in the plane through what it took that is parallel to the picture") {
    const auto position = cloth(16, 11, 0.05);
    Camera camera;
    camera.azimuth = 30.0f;
    const Lens lens = lens_of(camera);
    const glm::vec3 forward = forward_of(camera), taken(position.at(9, 4));
    Hand hand;
    CHECK_FALSE(hand.pull());
    hand.take_hold(*seen_at(lens, taken));
    hand.follow(position, flag_of(16, 11), lens, forward);
    REQUIRE(hand.held());
    CHECK(hand.held()->column == 9);
    CHECK(hand.held()->row == 4);
    const glm::vec2 there(700.0f, 150.0f);
    hand.move_to(there);
    hand.follow(position, flag_of(16, 11), lens, forward);
    const auto pull = hand.pull();
    REQUIRE(pull);
    CHECK(pull->across == Approx(9.0 / 15));
    CHECK(pull->down == Approx(4.0 / 10));
    const glm::vec3 target(pull->target);
    CHECK(glm::distance(*seen_at(lens, target), there) < 0.5f);
    CHECK(std::abs(glm::dot(target - taken, forward)) < 1e-3f);
    hand.let_go();
    hand.follow(position, flag_of(16, 11), lens, forward);
    CHECK_FALSE(hand.pull());
}

TEST_CASE("a hand that closes beside the cloth holds nothing until it opens, and what is fixed is not held") {
    const auto position = cloth(16, 11);
    const Lens lens = lens_of(Camera());
    const glm::vec3 forward = forward_of(Camera());
    Hand hand;
    hand.take_hold({5.0f, 5.0f});
    hand.follow(position, flag_of(16, 11), lens, forward);
    hand.move_to(*seen_at(lens, glm::vec3(position.at(9, 4))));
    hand.follow(position, flag_of(16, 11), lens, forward);
    CHECK_FALSE(hand.held());
    hand.take_hold(*seen_at(lens, glm::vec3(position.at(0, 4))));
    hand.follow(position, flag_of(16, 11), lens, forward);
    REQUIRE(hand.held());
    CHECK(hand.held()->column == 1);  // the pole's own column is fixed
}

TEST_CASE("a readout tells the length, the stretch and the force of a spring, and the speed and the pull of a mass") {
    Scene scene;
    scene.flag.columns = 3, scene.flag.rows = 1;
    scene.flag.width = 1.0;
    scene.springs = {
        .mass = 0.01, .stiffness = 100.0, .diagonal_stiffness = {}, .damping = {}, .drag = {}, .friction = {}};
    Snapshot snapshot;
    snapshot.position = FieldBuffer<float>(3, 1);
    snapshot.position.set(1, 0, {0.55, 0.0, 0.0});
    snapshot.position.set(2, 0, {1.0, 0.0, 0.0});
    Readout readout;
    readout.choose({.column = 0, .row = 0, .right = 1});
    readout.observe(snapshot, scene);
    const auto value = [&](const std::string& name) {
        for (const Quantity& quantity : readout.quantities())
            if (name == quantity.name) return quantity.value;
        FAIL("no " + name);
        return std::optional<double>();
    };
    CHECK(*value("Length") == Approx(550.0));
    CHECK(*value("Stretch") == Approx(10.0));
    CHECK(*value("Force") == Approx(5.0));  // 100 N/m times 50 mm

    readout.choose({.column = 1, .row = 0});
    readout.observe(snapshot, scene);
    CHECK_FALSE(value("Speed"));                     // the moment came without velocities
    CHECK(*value("Springs' pull") == Approx(10.0));  // 5 N from either side, both towards the hoist
    snapshot.time = 0.01;
    snapshot.position.set(1, 0, {0.55, 0.03, 0.04});
    snapshot.velocity = FieldBuffer<float>(3, 1);
    snapshot.velocity.set(1, 0, {0.0, 3.0, -4.0});
    readout.observe(snapshot, scene);
    CHECK(*value("Speed") == Approx(5.0));
    CHECK(*value("Upwards, y") == Approx(0.03));
    CHECK(readout.past().size() == 2);

    scene.flag.columns = 2;  // what was read is gone
    snapshot.position = FieldBuffer<float>(2, 1);
    readout.choose({.column = 2, .row = 0});
    readout.observe(snapshot, scene);
    CHECK_FALSE(readout.chosen());
}
