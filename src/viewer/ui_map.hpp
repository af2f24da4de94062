// UiMap: where every control of the window is and what it says, written each frame for tests that click real controls.
//
// With DRAPEAU_UI_MAP=FILE in the environment the window replaces FILE (written aside, then renamed) once a frame.
// The file is UTF-8 text, one record a line, fields separated by one tab; there are two kinds of records:
//
//   state<TAB>name<TAB>value                   what the window knows (three fields)
//   label<TAB>x0<TAB>y0<TAB>x1<TAB>y1<TAB>value  one control that can be seen and clicked now (six fields)
//
// x0 y0 is the control's upper left corner and x1 y1 its lower right one, in window pixels with the origin at the upper
// left corner of the window's content. A control scrolled out of its panel, in a closed list or on another page is not
// listed. `value` is what the control holds: 1 or 0 for switches and pages, a number in the unit the panel shows, a
// name for choices, the text of a text field, and nothing for buttons. Tabs and line breaks within a field become
// spaces.
//
// Labels are unique. Buttons, switches, sliders and lists have the label the panel shows ("Columns", "Pause"); pages
// are "Page: Flag"; readings "Reading: Stability"; the entries of an open list "Image: japan"; what
// galleries show "Flag: japan", "Open: storm"; the arrow that takes a control back to its default, there only when it
// differs, "Back: Columns"; the switch of a term "Damping on"; the number beside a slider's bar "Number: Columns". What
// a control says while the mouse rests on it is "Tip".
//
// State records:
//   frame            frames drawn since the start
//   scene            the scene's name
//   time             simulated seconds
//   steps            steps since the run began
//   paused           1 while paused, or stopped by a divergence or a failure
//   shown            s, the kept moment that is looked at, or nothing: the newest is shown
//   backwards        1 while what is kept plays backwards
//   speed            simulated seconds in a second of the clock, as wanted
//   kept_from kept_to kept  s, from when to when moments are kept, and how many
//   diverged         1 while the run stands on its last good frame
//   columns rows     of the masses drawn
//   texture          path of the image on the flag, or nothing
//   message          what the message box says, or nothing
//   message_box      x0 y0 x1 y1 of that box, or of the line that stands for a closed message; nothing without
//   question         what the window asks before it does something, or nothing
//   loading          the name of a file that is being read, or nothing
//   settling         1 while a hanging flag comes to rest before it starts
//   azimuth elevation  of the camera, degrees
//   distance         of the camera from what it looks at, m
//   target_x target_y target_z  what the camera looks at, m
//   held             x y of the mass that is held, in window pixels; nothing while none is
//   pull             N, of the hand that holds it
//   readout          which mass or spring is read, or nothing
//   readout_at       x y of it in window pixels, or nothing
//   wind_shown       the speed at the arrow, "6.1 m/s"; nothing while the wind is not shown
//   orbits           1 while the camera goes slowly around
//   framebuffer      its size in pixels, "1280x800"
//   window           the window's size in its own units, "1280x800"
//   panel            x0 y0 x1 y1 of the panel, separated by spaces; nothing when hidden or stepped aside
//   view             x0 y0 x1 y1 of what the panel leaves to the flag
//   flag             x0 y0 x1 y1 around the masses as drawn now
//   resting          1 while the next frame waits for an event or for time to pass, because nothing changes
//   help             1 while the list of keys is shown
//   palette          1 while the command palette is open
//   undo redo        what would be undone or redone, or nothing
//   force_scale      newtons of the reddest colour of the force colours
//   legend           what the colours and lengths mean: each title, its numbers, and whether they are fixed or
//                    automatic; " | " between legends
//   measuring        the share that is done of a measurement under way, or nothing
//   film             frames that are written of a film under way, or nothing
//   own_ms           ms of processor time that a frame costs the window itself, averaged (OwnWork)
//   gl_errors        OpenGL errors since the start (debug context)
#pragma once

#include <string>
#include <string_view>

namespace drapeau {

class UiMap {
public:
    /// Writes to the file named by DRAPEAU_UI_MAP; does nothing without it.
    UiMap();

    bool wanted() const { return !file_.empty(); }

    void state(std::string_view name, std::string_view value);
    void state(std::string_view name, double value);
    void control(std::string_view label, float x0, float y0, float x1, float y1, std::string_view value);

    /// Replaces the file by what was recorded since the last call.
    void write();

private:
    std::string file_;
    std::string text_;
};

}  // namespace drapeau
