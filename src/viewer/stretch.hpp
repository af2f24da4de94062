// Stretch of the cloth at its masses, as it is coloured, and the scale of those colours.
//
// Along each direction of its springs (fly, hoist and, where there are some, both diagonals) the stretch at a mass is
// the mean of (l - L) / L over the springs on its two sides, or over the one there is at a border. Of these the
// greatest counts: cloth that is pulled one way and gives way across is taut, and slack (zero or below) only where no
// direction is pulled. A mean over directions would show half of a plain pull, and nothing where pull and give are
// alike; the greatest size, with its sign, would jump between them.
//
// shaders/stretch.frag computes the same on the GPU.
#pragma once

#include "drapeau/state.hpp"
#include "force_scale.hpp"
#include "picture.hpp"

namespace drapeau {

/// Share: 0.05 is 5 % longer than at rest.
double stretch_at(const FieldBuffer<float>& position, const SpringKinds& kinds, int column, int row);

/// The share that the stretch of 19 masses in 20 does not exceed in size; of large cloths about 4000 masses are asked.
double usual_stretch(const FieldBuffer<float>& position, const SpringKinds& kinds);

/// The share at the ends of the stretch colours: a round number that follows the stretch without flicker.
class StretchScale {
public:
    void follow(const FieldBuffer<float>& position, const SpringKinds& kinds) {
        scale_.follow(usual_stretch(position, kinds));
    }
    double share() const { return scale_.end(); }

private:
    RoundScale scale_{0.9};  // colours are to use most of their range
};

}  // namespace drapeau
