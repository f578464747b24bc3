#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.hpp"
#include "scene/read_scene.hpp"

namespace sandgraph::scene {

// The error that a scene text (as file "s.toml") ends in; "accepted" if there is none.
inline std::string refused(const std::string& text, const std::vector<std::string>& overrides = {}) {
    try {
        parse_scene(text, "s.toml", overrides);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace sandgraph::scene
