// Hand: what the mouse does to the cloth itself: takes hold of it and pulls, or asks for a reading. Controls leave
// wishes; once a frame they are carried out on the cloth as it is seen.
#pragma once

#include "camera.hpp"
#include "picking.hpp"
#include "scene/scene.hpp"

#include "drapeau/pull.hpp"

#include <optional>
#include <utility>

namespace drapeau {

class Hand {
public:
    // What controls tell.
    void take_hold(glm::vec2 at) { wants_hold_ = true, mouse_ = at; }
    void move_to(glm::vec2 at) { mouse_ = at; }
    void let_go() { wants_hold_ = false, held_.reset(); }
    void click(glm::vec2 at) { clicked_ = at; }
    bool is_busy() const { return wants_hold_; }  // the button is down since it reached for the cloth

    /// Takes hold of what is seen under the mouse, and pulls it to where the mouse is now: in the plane through the
    /// place that was taken, parallel to the picture.
    void follow(const FieldBuffer<float>& position, const FlagSettings& flag, const Lens& lens, glm::vec3 forward);
    /// The click that nothing has been made of yet.
    std::optional<glm::vec2> take_click() { return std::exchange(clicked_, std::nullopt); }

    /// What pulls at the cloth; none while nothing is held.
    std::optional<Pull> pull() const;
    /// The mass that is held.
    struct Held {
        int column = 0, row = 0;
        double across = 0.0, down = 0.0;  // shares of the flag
        glm::vec3 plane{0.0f};            // m, a point of the plane that the mouse moves in
        glm::vec3 target{0.0f};           // m, where the mouse is in it
        glm::vec3 place{0.0f};            // m, of the mass as it is drawn
    };
    const std::optional<Held>& held() const { return held_; }

    static constexpr float reach = 14.0f;  // window units beside the cloth that still take hold of it

private:
    bool wants_hold_ = false;
    glm::vec2 mouse_{0.0f};
    std::optional<Held> held_;
    std::optional<glm::vec2> clicked_;
};

}  // namespace drapeau
