// ForceScale: the newtons of the reddest force colour, a round number that follows the forces without flicker.
#pragma once

namespace drapeau {

/// The smallest of 1, 2, 5 x 10^n that is not below `value`.
double rounded_up(double value);

/// A round number above a level that wavers. It shrinks once the level is below `hysteresis` times the next one.
class RoundScale {
public:
    explicit RoundScale(double hysteresis = 0.7) : hysteresis_(hysteresis) {}
    void follow(double level);
    double end() const { return shown_; }

private:
    double hysteresis_;
    double level_ = 0.0;  // quick to rise and slow to fall
    double shown_ = 1e-3;
};

class ForceScale {
public:
    /// Follows a new moment of the run, in which the spring forces have this root mean square (N).
    void follow(double rms_force) { scale_.follow(2.0 * rms_force); }
    double newtons() const { return scale_.end(); }

private:
    RoundScale scale_;
};

}  // namespace drapeau
