// Viewer: the parts of the window and what passes between them; a frame is input, exchange, draw, panels, present.
#pragma once

#include "app_state.hpp"
#include "camera.hpp"
#include "controls.hpp"
#include "double_press.hpp"
#include "film.hpp"
#include "filming.hpp"
#include "force_scale.hpp"
#include "gl_errors.hpp"
#include "gui.hpp"
#include "layout.hpp"
#include "library.hpp"
#include "loader.hpp"
#include "options.hpp"
#include "own_work.hpp"
#include "pacer.hpp"
#include "panels.hpp"
#include "render_target.hpp"
#include "renderer.hpp"
#include "rest.hpp"
#include "run_messages.hpp"
#include "scene_watch.hpp"
#include "simulation_thread.hpp"
#include "slow_motion.hpp"
#include "stretch.hpp"
#include "thumbnail_textures.hpp"
#include "ui_map.hpp"
#include "velocity_lines.hpp"
#include "window.hpp"

#include <memory>
#include <optional>

namespace drapeau {

/// A scene that takes the place of the one that flies, which goes on: pasted, or saved by another program.
struct OtherScene {
    Scene scene;                    // with the view as it is to be looked at
    std::optional<Scene> origin{};  // as the file has it; none of a text
    std::string place;              // what names its image, before a message: "storm.toml:7"
    std::string news;               // once it is taken
    bool other_image = false;       // than the one that is worn: this one, or none
    std::filesystem::path image_file{};
    std::optional<Image> image{};
};

/// What the command line says of the view.
void preset_view(const Options& options, ViewSettings& view);

class Viewer {
public:
    explicit Viewer(const Options& options);
    ~Viewer();

    bool running() const;
    void input();     // mouse and keys, to camera and settings
    void exchange();  // settings to the simulation, its newest moment back
    void draw();      // the scene
    void panels();    // the interface upon it
    void present();   // to the window and to files

    int exit_status() const;

    /// Makes the film of --record instead of all that; gives the exit status. Throws InputError.
    int make_film();

private:
    Viewer(const Options& options, LoadedScene loaded);

    bool repeatable() const { return options_.frames > 0; }
    bool keyboard_is_awaited() const;
    bool runs() const { return !app_.paused && !app_.status.stands(); }
    bool picture_wanted() const;
    Activity activity() const;
    glm::vec2 size() const;
    Picture picture() const;

    void load_wanted();
    void ask_before_loading();
    void use(Loaded loaded);
    void wear(const std::filesystem::path& file, std::optional<Image> image);
    void save_wanted();
    void save(const std::filesystem::path& file);
    void use_safe_step();
    void send_settings();
    void adopt(LoadedScene loaded);
    void set_image(const std::filesystem::path& file, std::optional<Image> image);
    void receive(double wall_seconds);
    void receive_moment();
    void receive_history();
    void show_moment();
    void travel(double passed);
    void play_backwards(double seconds);
    void step_to(double time);
    void look_at(const KeptMomentPtr& kept);
    void look_at_newest();
    void take_settings_of(const Moment& moment);
    void go_on_from_shown();
    void ask_for_time(double passed);
    double shown_time() const;
    bool is_slow() const;
    void receive_reference();
    void measure_wanted();
    void follow_hand();
    void hear_of_run();
    void keep_proportions();
    void film_wanted();
    void ask_film();
    void begin_film(const FilmPlan& plan, const Scene& scene, std::optional<Fork> start, const std::string& asked_by);
    void film_frame();
    void hear_of_film();
    void stop_film(const std::string& why);
    void save_shape();
    bool wants_velocities() const;
    bool transparent() const { return app_.scene.view.background == Background::transparent; }
    void take_screenshot(const std::filesystem::path& file);
    void write_map();

    // What is remembered (viewer_memory.cpp).
    void recall();  // between runs
    void remember();
    void save_remembered();
    void note_changes();  // of settings
    History::Entry entry_now() const;
    void undo_wanted();
    void restore_image(const std::filesystem::path& file);
    std::vector<InputEvent> wait_for_events();  // or for a scene file that is saved elsewhere
    void reload_wanted();
    void set_scene(OtherScene other);
    void take_scene(OtherScene other);
    bool drop_other_scene();
    void clipboard_wanted();

    Options options_;
    UiMap map_;
    Window window_;
    GlErrors gl_errors_;
    Gui gui_;
    RenderTarget target_;
    Renderer renderer_;
    std::unique_ptr<Film> film_;
    std::unique_ptr<Filming> filming_;
    std::optional<FilmPlan> film_asked_;  // until the simulation has told where it is
    SimulationThread simulation_;
    Loader loader_;
    Measuring measuring_;
    ThumbnailTextures thumbnail_textures_;

    AppState app_;
    PanelMemory panel_memory_;
    DoublePress double_press_;
    Controls controls_;
    Camera camera_;
    Framing framing_;
    Pacer pacer_;
    ForceScale force_scale_;
    StretchScale stretch_scale_;
    SpeedScale speed_scale_;
    ViewSettings seen_view_;  // of the frame before

    Moment newest_;            // of the run
    Moment moment_;            // that is shown: the newest, one between two, or a kept one
    KeptMomentPtr looked_at_;  // null: the newest
    SlowMotion slow_;
    bool picture_changed_ = false;
    double read_at_ = -1.0;        // s, the moment whose own readings were asked for
    long long awaited_ = 0;        // the revision of the run that is shown next
    ReferenceRun::Gap reference_;  // as it was last compared
    Scene sent_;                   // the scene the simulation was last given
    long long revision_ = 0;       // of sent_
    RunMessages run_messages_;
    std::optional<LoadedScene> opening_;  // until the simulation has taken it

    OwnWork own_work_;

    Rest rest_;
    double rest_seconds_ = 0.0;  // before the next frame
    bool had_events_ = false, hidden_ = false;

    SceneWatch watch_;
    bool file_changed_ = false;
    std::filesystem::path first_file_;      // the scene's that the command line speaks of
    std::filesystem::path restored_image_;  // that is being loaded for settings that name it already
    std::optional<OtherScene> other_;       // that is taken once its image is loaded
    std::filesystem::path settings_file_;   // empty: nothing is remembered
    UserSettings kept_settings_;            // as they are in the file
    double saved_settings_at_ = 0.0;        // s of wall-clock
    glm::ivec2 passing_size_{0};            // a window's size that is not to be remembered

    int frame_ = 0;
    double last_time_ = 0.0;  // s of wall-clock
    double wall_ = 0.0;       // s of wall-clock since the start
};

}  // namespace drapeau
