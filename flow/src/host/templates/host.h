// Specula @VERSION@: what a host sends to @NAME@_ip. C99, freestanding; nothing is allocated.
/*
 * View space is right-handed: x to the right, y up, z towards an eye at infinity. A host computes
 * what its vertices have, interpolates it linearly at the centres of a span's first and last pixel,
?registers| * and has @NAME@_packet make the words of the span's packet. @NAME@_registers makes the
?registers| * register writes of a frame, which come before its last packet word.
!registers| * and has @NAME@_packet make the words of the span's packet.
 *
 * Numbers are double.
?float| * With `#define @UPPER@_REAL float` before this file is included they are float. Then inputs are off
?float| * by as many units of their last place as stands below beside each.
 *
 * Words are those of Specula bit for bit where compilers evaluate double as double, without fusing
 * products and sums: give gcc -std=c99 or -ffp-contract=off.
 */
#ifndef @UPPER@_H
#define @UPPER@_H

#include <stdbool.h>
#include <stdint.h>
?math|#include <math.h> /* @MATH@ */

#if defined(__clang__) || !defined(__GNUC__)
#pragma STDC FP_CONTRACT OFF
#endif
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 1 || __FLT_EVAL_METHOD__ == 2)
#error "numbers are evaluated with more bits than they have: give gcc -msse2 -mfpmath=sse"
#endif

?float|#ifndef @UPPER@_REAL
?float|#define @UPPER@_REAL double
?float|#endif
?float|typedef @UPPER@_REAL @NAME@_real;
!float|#ifdef @UPPER@_REAL
!float|#error "host code of this core is for double alone"
!float|#endif
!float|typedef double @NAME@_real;

/* Words of a packet. */
#define @UPPER@_WORDS @WORDS@
/* The most pixels of a span. */
#define @UPPER@_LONGEST_SPAN @LONGEST@u
?registers|/* Register writes of a frame. */
?registers|#define @UPPER@_WRITES @WRITES@

?material|/* A material. */
?material|struct @NAME@_material {
@MATERIAL_FIELDS@
?material|};

?frame|/* What holds for a frame. */
?frame|struct @NAME@_frame {
@FRAME_FIELDS@
?frame_material|  /* the material of all surfaces */
?frame_material|  struct @NAME@_material material;
?frame|};

/* A span: a run of pixels of one triangle in one row. */
struct @NAME@_span {
  /* pixels, 1 to @LONGEST@ */
  uint32_t pixels;
  /* whether it is the last span of its frame */
  bool last;
?positions|  /* column and row of the first pixel, 0 to 65535 */
?positions|  uint32_t x, y;
@SPAN_FIELDS@
?span_material|  /* the material of its triangle */
?span_material|  const struct @NAME@_material *material;
};

?registers|/* A word for a register. */
?registers|struct @NAME@_write {
?registers|  uint32_t address;
?registers|  uint32_t word;
?registers|};

/* A vector. */
struct @NAME@_vector {
  @NAME@_real x, y, z;
};

/* The nearest whole number, ties up: 0 of what is no number, and no more than about 2^62. */
static inline int64_t @NAME@_rounded(@NAME@_real value, int64_t ones) {
  const @NAME@_real scaled = value * (@NAME@_real)ones;
  const int64_t largest = 4611685468671574016LL;
  int64_t whole;
  if (scaled != scaled) return 0;
  if (scaled >= (@NAME@_real)largest) return largest;
  if (scaled <= -(@NAME@_real)largest) return -largest;
  whole = (int64_t)scaled;
  whole -= (@NAME@_real)whole > scaled ? 1 : 0;
  return whole + (scaled - (@NAME@_real)whole >= (@NAME@_real)0.5 ? 1 : 0);
}

/* A value in units of its last place, of which there are `ones` in 1, from low to high. */
static inline int64_t @NAME@_raw(@NAME@_real value, int64_t ones, int64_t low, int64_t high) {
  const int64_t raw = @NAME@_rounded(value, ones);
  return raw < low ? low : raw > high ? high : raw;
}

?difference|/* The difference of two values that are rounded before. */
?difference|static inline int64_t @NAME@_raw_difference(
?difference|    @NAME@_real from, @NAME@_real to, int64_t ones, int64_t low, int64_t high) {
?difference|  const int64_t raw = @NAME@_rounded(to, ones) - @NAME@_rounded(from, ones);
?difference|  return raw < low ? low : raw > high ? high : raw;
?difference|}

@FUNCTIONS@

/* The words of a span's packet, the first one first. */
static inline void @NAME@_packet(
?packet_frame|    const struct @NAME@_frame *frame,
    const struct @NAME@_span *span, uint@WORD@_t words[@UPPER@_WORDS]) {
@PACKET_BODY@
}

?registers|/* The register writes of a frame, in any order. */
?registers|static inline void @NAME@_registers(
?registers|    const struct @NAME@_frame *frame, struct @NAME@_write writes[@UPPER@_WRITES]) {
@REGISTERS_BODY@
?registers|}

#endif
