// Shades spans, over and over, and times itself.
//
//     run STIMULUS RESULT SPANS DUMP
//
// STIMULUS holds a frame: its spans, a line each, and behind them the idle clocks, in lines of any length. It is read into memory first. The
// time is that of one clock of reset, the first SPANS spans of an endless row of such frames, and the idle clocks; when built with
// --trace or --trace-fst, every signal is written to DUMP once a clock, and opening and closing it counts.
//
// RESULT gets the seconds, the number of clocks, and the sum of each code over the clocks in which pixels leave, modulo 2^32.
//
// What depends on the core stands in ports.h.
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "Vcore.h"
#include "verilated.h"
#if VM_TRACE_FST
#include "verilated_fst_c.h"
using Dump = VerilatedFstC;
#elif VM_TRACE
#include "verilated_vcd_c.h"
using Dump = VerilatedVcdC;
#endif

#include "ports.h"

struct InputHold {
    uint64_t clocks;
    uint64_t valid;
    uint64_t starts;
    uint64_t inputs[INPUTS > 0 ? INPUTS : 1];
};

static bool read_number(std::FILE* file, uint64_t& number) { return std::fscanf(file, "%" SCNx64, &number) == 1; }

static std::vector<InputHold> read_stimulus(const char* name) {
    std::vector<InputHold> all;
    std::FILE* file = std::fopen(name, "r");
    if (!file) return all;
    InputHold next;
    while (read_number(file, next.clocks) && read_number(file, next.valid) && read_number(file, next.starts)) {
        for (int i = 0; i < INPUTS && read_number(file, next.inputs[i]); ++i) continue;
        all.push_back(next);
    }
    std::fclose(file);
    return all;
}

// Every signal of the core, if this program traces.
class Waves {
   public:
#if VM_TRACE
    Waves(Vcore& core, const char* name) {
        core.trace(&dump_, 99);
        dump_.open(name);
    }
    ~Waves() { dump_.close(); }
    bool good() const { return dump_.isOpen(); }
    void sample() { dump_.dump(clock_++); }

   private:
    Dump dump_;
    uint64_t clock_ = 0;
#else
    Waves(Vcore&, const char*) {}
    bool good() const { return true; }
    void sample() {}
#endif
};

class Run {
   public:
    Run(Vcore& core, Waves& waves) : core_{core}, waves_{waves} {}

    void reset() {
        set_reset(core_, 1);
        fall();
        rise();
        set_reset(core_, 0);
    }

    void shade(const InputHold& span) {
        for (int i = 0; i < INPUTS; ++i) set_input(core_, i, span.inputs[i]);
        for (uint64_t clock = 0; clock < span.clocks; ++clock) tick(span.valid, span.starts && clock == 0);
    }

    // Inputs stay as they are.
    void idle(uint64_t clocks) {
        for (uint64_t clock = 0; clock < clocks; ++clock) tick(0, 0);
    }

    uint64_t clocks = 0;
    uint32_t sums[CODES] = {};

   private:
    void tick(uint64_t valid, uint64_t start) {
        set_control(core_, valid, start);
        fall();
        if (leaves(core_)) add_codes(core_, sums);
        waves_.sample();
        rise();
        ++clocks;
    }

    void rise() {
        set_clock(core_, 1);
        core_.eval();
    }

    void fall() {
        set_clock(core_, 0);
        core_.eval();
    }

    Vcore& core_;
    Waves& waves_;
};

static bool write_result(const char* name, double seconds, const Run& run) {
    std::FILE* file = std::fopen(name, "w");
    if (!file) return false;
    std::fprintf(file, "%.9f %" PRIu64, seconds, run.clocks);
    for (const uint32_t sum : run.sums) std::fprintf(file, " %" PRIu32, sum);
    return std::fclose(file) == 0;
}

int main(int count, char** arguments) {
    if (count != 5) return std::fputs("usage: run STIMULUS RESULT SPANS DUMP\n", stderr), 2;
    const std::vector<InputHold> frame = read_stimulus(arguments[1]);
    size_t spans_of_frame = 0;
    uint64_t idle = 0;
    for (const InputHold& hold : frame) {
        if (hold.valid) ++spans_of_frame;
        else idle += hold.clocks;
    }
    if (spans_of_frame == 0) return std::fputs("run: there is no span\n", stderr), 1;
    const uint64_t spans = std::strtoull(arguments[3], nullptr, 10);
    const std::unique_ptr<VerilatedContext> context{new VerilatedContext};
    context->traceEverOn(VM_TRACE);
    const std::unique_ptr<Vcore> core{new Vcore{context.get()}};

    const auto begin = std::chrono::steady_clock::now();
    std::unique_ptr<Waves> waves{new Waves{*core, arguments[4]}};
    if (!waves->good()) return std::perror("run"), 1;
    Run run{*core, *waves};
    run.reset();
    size_t next = 0;
    for (uint64_t done = 0; done < spans; ++done) {
        run.shade(frame[next]);
        if (++next == spans_of_frame) next = 0;
    }
    run.idle(idle);
    waves.reset();
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;

    core->final();
    if (!write_result(arguments[2], taken.count(), run)) return std::perror("run"), 1;
    return 0;
}
