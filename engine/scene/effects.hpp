#pragma once
#include <span>
#include <string>

#include "scene/file_kind.hpp"
#include "scene/key_table.hpp"

// A key that can have no effect is refused, not ignored: whoever writes it believes that it does something.
//
// It is refused where it contradicts what was written at the same place: in a file beside the file's own (or
// the default) choice, on the command line beside any. A file's key that loses its effect by an override is
// left alone, so that one scene serves several laws, modes and packings:
//   run anchor.toml --set ground.law=mohr_coulomb     [grains] of anchor.toml may stay
//   run anchor.toml --set continuum.young="20 MPa"    refused: the law is "rve"
namespace sandgraph::scene {

// When the keys of a table, or a single key, have an effect.
struct EffectRule {
    const char* keys;        // "continuum", all of the table, or one key, "continuum.cohesion"
    const char* decided_by;  // the key that decides, itself free of the rule; "": they never have one
    enum class If : std::uint8_t { is, is_not } when;
    const char* values;  // of that key, as files have them, parted by '|'
    // What says why they have none, and what to write instead. {is}: the deciding key with its value and
    // whether that is the default, {value}: the value alone.
    const char* why;
    const char* advice = "leave it out";
    bool may_stand = false;  // in a file, which is run either way
};

// The rules of a kind of file.
std::span<const EffectRule> effect_rules(FileKind kind);

// Has `key` of `keys` no effect as things stand, in whatever mode the file is run?
bool is_idle(const KeyTable& keys, const Key& key, FileKind kind);

// Throws InputError at the first given key that has no effect, unless it may stand (see above).
void check_effects(const KeyTable& keys, FileKind kind);

}  // namespace sandgraph::scene
