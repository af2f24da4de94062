// Message: what the message box says. There is one box: whatever is said later takes its place, Esc and its button
// close it, and news of a success go by themselves. When each cause's message appears and goes by itself:
//
//   cause       appears                                          goes
//   image       an image cannot be loaded, a scene's own too     an image is loaded, or none is wanted
//   scene       a scene cannot be opened or pasted, or its       a scene is opened, or the file is read again; news
//               file was saved elsewhere; one is copied          of what went well after some seconds
//   save        a scene is saved, or cannot be                   the next one is (which says so in its place)
//   screenshot  a screenshot is saved, or cannot be              the next one is
//   film        a film or a shape is saved, or cannot be         the next one is
//   refusal     the run refuses settings, which are taken back   other settings are taken
//   standstill  the run stops                                    the run goes on; closed before that, a line in its
//                                                                place says that the run stopped and opens it again
//   settings    what is remembered cannot be read                it is closed
//               it cannot be kept, or was forgotten              after some seconds
//   history     settings are undone or redone                     after some seconds
//   typed       a number cannot be taken as it was typed         after some seconds
//   lowered     an automatic step is lowered, once a scene       after some seconds
#pragma once

#include "io/text.hpp"

#include <string>

namespace drapeau {

struct Message {
    enum class Cause { image, scene, save, screenshot, film, refusal, standstill, settings, history, typed, lowered };
    std::string text{};
    bool trouble = true;
    double seconds_left = 0.0;  // it goes by itself; 0: it stays until closed
    Cause cause = Cause::image;

    /// The text as the box shows it, whatever names it holds.
    std::string shown() const { return printable(text); }
};

/// Ends a cause: its message goes, another stays.
inline void close_if(Message& message, Message::Cause cause) {
    if (message.cause == cause) message.text.clear();
}

}  // namespace drapeau
