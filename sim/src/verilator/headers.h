// The headers that programs include, whatever their core is. A library of common parts has them compiled.
#ifndef SPECULA_HEADERS_H
#define SPECULA_HEADERS_H

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <vector>

#include "verilated.h"
#if VM_TRACE
#include "verilated_vcd_c.h"
#endif

#endif
