#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "scene/key_table.hpp"

// The table of a sweep: a base scene, and what is varied from run to run.
namespace sandgraph::scene {

// A value of a scene's key: as TOML has it ('7 m' in quotes), and as people read it (7 m).
struct SweepValue {
    std::string toml, text;
};

// `key = value` of a scene, and where the table says so.
struct SweepSetting {
    std::string key;
    SweepValue value;
    InputError::Where where;
};

// [[axis]]: values of a key, and of others that go along with it.
struct SweepAxis {
    std::vector<std::string> keys;               // its own, then those of `with`
    std::vector<std::vector<SweepValue>> steps;  // a value for each of the keys
    InputError::Where where;
};

enum class Combine : std::uint8_t { product, zip };
enum class SweepMode : std::uint8_t { scene, full, screening };  // scene: as the scene says

struct SweepSpec {
    std::string file, title;
    std::string scene;  // TOML file of the base scene
    SweepMode mode = SweepMode::scene;
    Combine combine = Combine::product;
    std::string rows;               // CSV file instead of axes; "": none
    int samples = 1;                // base packings a row
    std::vector<SweepSetting> set;  // of all rows
    std::vector<SweepAxis> axes;
    GivenKeys given;

    InputError::Where where(std::string_view key) const {
        const auto it = given.find(key);
        return it != given.end() ? it->second : InputError::Where{file, 0};
    }
};

}  // namespace sandgraph::scene
