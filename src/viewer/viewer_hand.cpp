// The viewer's part in touching the cloth: what the hand wished for since the last frame, on the cloth as it was drawn.
#include "viewer.hpp"

#include <glm/geometric.hpp>

namespace drapeau {

void Viewer::follow_hand() {
    const FieldBuffer<float>& position = moment_.snapshot.position;
    app_.lens = {camera_.projection(framing_, app_.view_area, size()) * camera_.view_matrix(framing_, app_.view_area),
                 size()};
    const glm::vec3 forward = glm::normalize(camera_.target(framing_) - camera_.eye(framing_, app_.view_area));
    app_.hand.follow(position, moment_.scene.flag, app_.lens, forward);
    if (const auto at = app_.hand.take_click()) {
        const auto picked = pick(position, app_.lens, *at, Hand::reach);
        const ViewSettings& view = app_.scene.view;
        if (picked)
            app_.readout.choose(nearest_part(position, app_.lens, *at, *picked, view.springs || view.forces,
                                             moment_.kinds.diagonal.exists()));
        else
            app_.readout.close();
    }
    simulation_.pull(app_.hand.pull());
}

}  // namespace drapeau
