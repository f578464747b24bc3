#include <csignal>
#include <string_view>

#include "app/command_line.hpp"
#include "base/console.hpp"
#include "mpi/mpi_team.hpp"
#include "ranks/follower.hpp"
#include "ranks/leader.hpp"

namespace {

using namespace sandgraph;

bool shares_out(int argc, char** argv) {
    const std::string_view command = argc > 1 ? argv[1] : "";
    return command == "run" || command.starts_with('-');  // --help
}

int lead(mpi::MpiTeam& team, int argc, char** argv) {
    if (team.size() > 1 && !shares_out(argc, argv)) {
        notice("sandgraph: several ranks (only the packings of `run` are shared out); start it without mpi");
        return app::exit_bad_input;
    }
    return app::run_command_line(argc, argv, std::make_shared<ranks::Leader>(team));
}

// mpirun hands on SIGUSR1, not SIGTERM: on that it kills. Rank 0 ends the run at its next step, as on
// SIGTERM.
void stop_on_usr1(int) { std::raise(SIGTERM); }

// Rank 0 is asked to stop, too, and tells the others.
void leave_signals_to_rank_0() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) std::signal(signal, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
    mpi::MpiTeam team(argc, argv);
    if (team.rank() != 0) {
        leave_signals_to_rank_0();
        ranks::follow(team);
        return app::exit_done;
    }
    std::signal(SIGUSR1, stop_on_usr1);
    const int code = lead(team, argc, argv);
    ranks::tell(team, {});
    return code;
}
