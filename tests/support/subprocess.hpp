#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include "support/paths.hpp"

namespace sandgraph::app {

// A scratch folder and the sandgraph binary run in it.
class Shell {
  public:
    explicit Shell(const std::string& name)
        : folder_(std::filesystem::temp_directory_path() /
                  ("sandgraph_test_" + name + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~Shell() { std::filesystem::remove_all(folder_); }
    Shell(const Shell&) = delete;
    Shell& operator=(const Shell&) = delete;

    struct Outcome {
        int exit_code;
        std::string out, err;
    };
    Outcome run(const std::string& arguments) const {
        const std::string command = "cd '" + folder_.string() + "' && '" + sandgraph::test::program() + "' " +
                                    arguments + " >.out 2>.err";
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read(".out"), read(".err")};
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    std::string read(const std::string& name) const {
        std::ifstream in(folder_ / name, std::ios::binary);
        return (std::ostringstream() << in.rdbuf()).str();
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    // Files in the folder, hidden ones apart.
    int files() const {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            count += entry.path().filename().string().front() != '.';
        return count;
    }

  private:
    std::filesystem::path folder_;
};

}  // namespace sandgraph::app
