// Viewer: the parts of the window and what passes between them; a frame is input, exchange, draw, panels, present.
#pragma once

#include "app_state.hpp"
#include "camera.hpp"
#include "controls.hpp"
#include "film.hpp"
#include "force_scale.hpp"
#include "gl_errors.hpp"
#include "gui.hpp"
#include "layout.hpp"
#include "library.hpp"
#include "loader.hpp"
#include "options.hpp"
#include "pacer.hpp"
#include "panels.hpp"
#include "render_target.hpp"
#include "renderer.hpp"
#include "rest.hpp"
#include "run_messages.hpp"
#include "simulation_thread.hpp"
#include "ui_map.hpp"
#include "window.hpp"

#include <memory>
#include <optional>

namespace drapeau {

class Viewer {
public:
    explicit Viewer(const Options& options);

    bool running() const;
    void input();     // mouse and keys, to camera and settings
    void exchange();  // settings to the simulation, its newest moment back
    void draw();      // the scene
    void panels();    // the interface upon it
    void present();   // to the window and to files

    int exit_status() const;

private:
    Viewer(const Options& options, LoadedScene loaded);

    bool repeatable() const { return options_.frames > 0; }
    bool runs() const { return !app_.paused && !app_.status.stands(); }
    bool picture_wanted() const;
    Activity activity() const;
    glm::vec2 size() const;
    Picture picture() const;

    void load_wanted();
    void use(Loaded loaded);
    void wear(const std::filesystem::path& file, std::optional<Image> image);
    void save_wanted();
    void save(const std::filesystem::path& file);
    void use_safe_step();
    void send_settings();
    void adopt(LoadedScene loaded);
    void set_image(const std::filesystem::path& file, std::optional<Image> image);
    void receive(double wall_seconds);
    void receive_reference();
    void measure_wanted();
    void follow_hand();
    void hear_of_run();
    void keep_proportions();
    void take_screenshot(const std::filesystem::path& file);
    void write_map();

    Options options_;
    UiMap map_;
    Window window_;
    GlErrors gl_errors_;
    Gui gui_;
    RenderTarget target_;
    Renderer renderer_;
    std::unique_ptr<Film> film_;
    SimulationThread simulation_;
    Loader loader_;
    Measuring measuring_;

    AppState app_;
    PanelMemory panel_memory_;
    Controls controls_;
    Camera camera_;
    Framing framing_;
    Pacer pacer_;
    ForceScale force_scale_;

    Moment moment_;
    ReferenceRun::Gap reference_;  // as it was last compared
    Scene sent_;                   // the scene the simulation was last given
    long long revision_ = 0;       // of sent_
    RunMessages run_messages_;
    std::optional<LoadedScene> opening_;  // until the simulation has taken it

    Rest rest_;
    double rest_seconds_ = 0.0;  // before the next frame
    bool had_events_ = false, hidden_ = false;

    int frame_ = 0;
    double last_time_ = 0.0;  // s of wall-clock
    double wall_ = 0.0;       // s of wall-clock since the start
};

}  // namespace drapeau
