// Drives a core: one clock of reset, then the clocks of the stimulus.
//
//     run STIMULUS RESULTS PORT...   writes the ports of these numbers, one 64-bit number each, at every clock
//     run STIMULUS TRACE             writes every signal as a VCD, clock r of the run at time r (built with --trace)
//
// What depends on the core stands in ports.h.
#include "headers.h"

#include "Vcore.h"
#include "ports.h"

// Where values go.
class Results {
   public:
#if VM_TRACE
    Results(Vcore& core, int, char** arguments) {
        core.trace(&vcd_, 99);
        vcd_.open(arguments[2]);
    }
    ~Results() { vcd_.close(); }
    bool good() { return vcd_.isOpen(); }
    void sample(const Vcore&) { vcd_.dump(clock_++); }

   private:
    VerilatedVcdC vcd_;
    uint64_t clock_ = 0;
#else
    Results(Vcore&, int count, char** arguments) : file_{std::fopen(arguments[2], "wb")} {
        for (int i = 3; i < count; ++i) ports_.push_back(std::atoi(arguments[i]));
        row_.resize(ports_.size());
    }
    ~Results() {
        if (file_) std::fclose(file_);
    }
    bool good() { return file_ && !std::ferror(file_) && !std::fflush(file_); }
    void sample(const Vcore& core) {
        for (size_t i = 0; i < ports_.size(); ++i) row_[i] = port(core, ports_[i]);
        std::fwrite(row_.data(), sizeof(uint64_t), row_.size(), file_);
    }

   private:
    std::FILE* file_;
    std::vector<int> ports_;
    std::vector<uint64_t> row_;
#endif
};

static void rise(Vcore& core) {
    set_clock(core, 1);
    core.eval();
}

static void fall(Vcore& core) {
    set_clock(core, 0);
    core.eval();
}

static void reset(Vcore& core) {
    set_reset(core, 1);
    fall(core);
    rise(core);
    set_reset(core, 0);
}

static bool read_number(std::FILE* file, uint64_t& number) { return std::fscanf(file, "%" SCNx64, &number) == 1; }

static void drive(Vcore& core, std::FILE* stimulus, Results& results) {
    uint64_t clocks, valid, starts, value;
    while (read_number(stimulus, clocks) && read_number(stimulus, valid) && read_number(stimulus, starts)) {
        for (int i = 0; i < INPUTS && read_number(stimulus, value); ++i) set_input(core, i, value);
        for (uint64_t clock = 0; clock < clocks; ++clock) {
            set_control(core, valid, starts && clock == 0);
            fall(core);
            results.sample(core);
            rise(core);
        }
    }
}

int main(int count, char** arguments) {
    if (count < 3) return std::fputs("usage: run STIMULUS RESULTS [PORT...]\n", stderr), 2;
    const std::unique_ptr<VerilatedContext> context{new VerilatedContext};
    context->traceEverOn(VM_TRACE);
    const std::unique_ptr<Vcore> core{new Vcore{context.get()}};
    Results results{*core, count, arguments};
    std::FILE* stimulus = std::fopen(arguments[1], "r");
    if (!stimulus || !results.good()) return std::perror("run"), 1;
    reset(*core);
    drive(*core, stimulus, results);
    std::fclose(stimulus);
    core->final();
    if (!results.good()) return std::perror("run"), 1;
    return 0;
}
