#pragma once
#include <memory>

#include "base/byte_stream.hpp"
#include "base/contracts.hpp"
#include "base/tensor.hpp"
#include "dem/fast/kernel.hpp"
#include "dem/fast/neighbour_list.hpp"
#include "dem/mixed/list.hpp"
#include "dem/mixed/state.hpp"
#include "dem/packing/compact_packing.hpp"
#include "dem/packing/observables.hpp"
#include "dem/packing/packing.hpp"
#include "dem/rve_options.hpp"
#include "dem/strain_run.hpp"

namespace sandgraph::dem {

enum class RveStatus : std::uint8_t {
    ok,
    floating,       // no contacts: stress exactly zero, no cost
    bad_increment,  // singular, inverted or absurd increment: state left as it was
    diverged,       // not finite, or the cell became too thin to be periodic: state left as it was
};

inline bool failed(RveStatus s) { return s == RveStatus::bad_increment || s == RveStatus::diverged; }

struct RveReport {
    RveStatus status = RveStatus::ok;
    int dem_steps = 0;
    double inertial_number = 0;
    bool unfinished = false;  // steps_max was reached: the rest of the strain is driven with the next update
};

// Scratch memory of one thread; RVEs visit it one after the other.
struct Workspace {
    FastState state;
    NeighbourList neighbours;
    MixedState mixed;  // of RveKernel::mixed
    MixedList mixed_list;
};

// The grains of one material point. The packing lives in a frame that turns with the point, so rotations are
// exact and free, and only the stretch is driven through DEM steps.
class Rve {
  public:
    // Shares the initial packing of its depth row; an own copy is made by the first update.
    explicit Rve(std::shared_ptr<const CompactPacking> initial) : initial_(std::move(initial)) {
        SG_EXPECT(initial_ != nullptr);
    }

    // Drives the packing through the increment F_inc (lab frame, det > 0). After a report other than `ok` or
    // `floating` the state is unchanged and `stress()` still that of before.
    RveReport update(const Mat2& F_inc, const Material& material, const RveOptions& options, Workspace& work);

    // Strain (Hencky norm) that an update covers with one DEM step.
    double strain_per_step(const Material& material, const RveOptions& options) const;

    // Cauchy stress [Pa], compression positive, lab frame; not symmetrised.
    Mat2 stress() const;
    bool owns_packing() const { return own_ != nullptr; }
    bool floating() const { return floating_; }
    double angle() const { return angle_; }          // rotation of the packing's frame [rad]
    double volume_ratio() const { return volume_; }  // J since the start
    double porosity() const;
    // Strain of an unfinished update that the grains have still to follow, lab frame, tension positive.
    Mat2 strain_to_follow() const;
    const CompactPacking& packing() const { return own_ ? *own_ : *initial_; }

    // For checkpoints. The initial packing is not part of the state; StateError for what is no state of it.
    void save(ByteWriter& out) const;
    void load(ByteReader& in);

  private:
    bool keep_floating(const Mat2& U);
    RveReport drive(const Mat2& stretch, const Material& material, const RveOptions& options, Workspace& work,
                    Mat2& rest);
    void settle(const RveOptions& options);

    std::shared_ptr<const CompactPacking> initial_;
    std::unique_ptr<CompactPacking> own_;
    bool floating_ = false;
    double angle_ = 0, volume_ = 1;
    double contact_volume_ = 1;  // J when the packing last carried load
    // Deformation that the grains have not followed yet: collected while floating, or the rest of an
    // unfinished update; packing frame.
    Mat2 pending_ = Mat2::Identity();
    StrainRun run_;
};

// The packing behind a material point as it lies in the lab frame (the Rve keeps it in a frame that turns
// with the point), with its contact history. A floating packing is shown as it last carried load.
Packing lab_packing(const Rve& rve);

// What the packing shows behind a material point, turned into the lab frame; `stress` is what the RVE
// answers, `porosity` includes what a floating packing has opened.
Observables observe(const Rve& rve, const Material& material);

// What a DEM update of a watched point did, for the history log.
struct RveUpdate {
    std::int32_t point = 0;
    Mat2 F_inc = Mat2::Identity();  // since the point's previous update, with its spin
    RveReport report;
    Mat2 stress = Mat2::Zero();  // after it [Pa], compression positive, lab frame, not symmetrised
    double volume_ratio = 1;     // J since the start
    Observables seen;            // lab frame
};

}  // namespace sandgraph::dem
