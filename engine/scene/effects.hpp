#pragma once
#include <string>
#include <vector>

#include "scene/key_table.hpp"

// A key that can have no effect is refused, not ignored: whoever writes it believes that it does something.
//
// It is refused where it contradicts what was written at the same place: in a file beside the file's own (or
// the default) choice, on the command line beside any. A file's key that loses its effect by an override is
// left alone, so that one scene serves several laws, modes and packings:
//   run anchor.toml --set ground.law=mohr_coulomb     [grains] of anchor.toml may stay
//   run anchor.toml --set continuum.young="20 MPa"    refused: the law is "rve"
namespace sandgraph::scene {

struct Scene;
struct RecipeSpec;
struct ElementTestSpec;
struct ProbeSpec;
struct TrainSpec;

// When the keys of a table, or a single key, have an effect.
struct EffectRule {
    std::string keys;        // "continuum", all of the table, or "continuum.cohesion"
    bool effective;          // as things stand
    std::string decided_by;  // the key that decides it, itself free of the rule; "": nothing that is written
    std::string why;         // they have none
    std::string advice;      // what to write instead
    bool may_stand = false;  // in a file, which is run in both modes
};
using EffectRules = std::vector<EffectRule>;

// The rules of each kind of file, for what has been read into `keys` and its struct.
EffectRules effect_rules(const Scene& scene, const KeyTable& keys);
EffectRules effect_rules(const RecipeSpec& recipe, const KeyTable& keys);
EffectRules effect_rules(const ElementTestSpec& test, const KeyTable& keys);
EffectRules effect_rules(const ProbeSpec& probe, const KeyTable& keys);
EffectRules effect_rules(const TrainSpec& train, const KeyTable& keys);

// The first rule by which `key` has no effect, or null.
const EffectRule* idle_by(const EffectRules& rules, const Key& key);

// Throws InputError at the first given key that has no effect, unless it may stand (see above).
void check_effects(const KeyTable& keys, const EffectRules& rules);

}  // namespace sandgraph::scene
