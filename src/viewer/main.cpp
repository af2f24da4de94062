// drapeau: the window. Exit status 0 good, 1 a failure, 2 bad input, 3 a run to files that diverged, 128 and the signal
// if one stopped a film.
#include "film_options.hpp"
#include "options.hpp"
#include "viewer.hpp"

#include "io/error.hpp"
#include "io/terminal.hpp"

#include <csignal>
#include <exception>
#include <new>

int main(int count, char** words) {
    drapeau::Options options;
    if (const auto status = drapeau::read_options(count, words, options)) return *status;
    std::signal(SIGPIPE, SIG_IGN);  // a pipe whose reader is gone is noticed when writing
    try {
        if (!options.obj.empty()) return drapeau::write_shapes(options);
        drapeau::Viewer viewer(options);
        if (!options.record.empty()) return viewer.make_film();
        while (viewer.running()) {
            viewer.input();
            viewer.exchange();
            viewer.draw();
            viewer.panels();
            viewer.present();
        }
        return viewer.exit_status();
    } catch (const drapeau::InputError& wrong) {
        drapeau::complain("drapeau", wrong.what());
        return 2;
    } catch (const std::bad_alloc&) {
        drapeau::complain("drapeau", "not enough memory");
        return 1;
    } catch (const std::exception& failure) {
        drapeau::complain("drapeau", failure.what());
        return 1;
    }
}
