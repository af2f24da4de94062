// Rest: how long the render loop may wait for the next event. While nothing changes no frame is drawn.
#pragma once

namespace drapeau {

/// What goes on in the window after a frame.
struct Activity {
    bool events = false;        // something happened to the window in this frame
    bool runs = false;          // simulated time passes
    bool simulation = false;    // it works on something or has news, or a file is being read
    bool hidden = false;        // nobody sees the window
    bool typing = false;        // a text cursor blinks
    double message_left = 0.0;  // s until the message goes by itself; 0: it stays, or there is none
    double panel_left = 0.0;  // s until a control changes by itself: a tip that comes, a click that sets; 0: none does
};

class Rest {
public:
    /// Seconds until the next frame unless something happens to the window; 0: the next frame follows at once.
    double seconds(const Activity& activity);

private:
    int settling_ = 0;  // frames since the last change that are still to be drawn
    double message_left_ = 0.0, panel_left_ = 0.0;
};

}  // namespace drapeau
