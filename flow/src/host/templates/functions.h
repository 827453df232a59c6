=== load
/* A vector of a struct. */
static inline struct @vector @load(const @real components[3]) {
  const struct @vector v = {components[0], components[1], components[2]};
  return v;
}
=== eye
/* V, the direction to an eye at infinity. */
static inline struct @vector @eye(void) {
  const struct @vector v = {0, 0, 1};
  return v;
}
=== component_x
static inline @real @component_x(struct @vector a) { return a.x; }
=== component_y
static inline @real @component_y(struct @vector a) { return a.y; }
=== component_z
static inline @real @component_z(struct @vector a) { return a.z; }
=== dot
static inline @real @dot(struct @vector a, struct @vector b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
=== plus
static inline struct @vector @plus(struct @vector a, struct @vector b) {
  const struct @vector v = {a.x + b.x, a.y + b.y, a.z + b.z};
  return v;
}
=== minus
static inline struct @vector @minus(struct @vector a, struct @vector b) {
  const struct @vector v = {a.x - b.x, a.y - b.y, a.z - b.z};
  return v;
}
=== negative
static inline struct @vector @negative(struct @vector a) {
  const struct @vector v = {-a.x, -a.y, -a.z};
  return v;
}
=== times
static inline struct @vector @times(struct @vector a, @real factor) {
  const struct @vector v = {a.x * factor, a.y * factor, a.z * factor};
  return v;
}
=== over
static inline struct @vector @over(struct @vector a, @real divisor) {
  const struct @vector v = {a.x / divisor, a.y / divisor, a.z / divisor};
  return v;
}
=== cross
static inline struct @vector @cross(struct @vector a, struct @vector b) {
  const struct @vector v = {
      a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y};
  return v;
}
=== root
static inline @real @root(@real x) { return (@real)sqrt((double)x); }
=== length
static inline @real @length(struct @vector a) { return @root(@dot(a, a)); }
=== larger
static inline @real @larger(@real a, @real b) { return a > b ? a : b; }
=== is_zero
static inline bool @is_zero(struct @vector a) { return a.x == 0 && a.y == 0 && a.z == 0; }
=== unit
/* A vector of length 1 in the direction of another; 0 where that has none. */
static inline struct @vector @unit(struct @vector a) {
  const struct @vector none = {0, 0, 0};
  const @real length = @length(a);
  return length > 0 && 1 / length > 0 ? @times(a, 1 / length) : none;
}
=== or_else
/* A vector, or another one where it is 0. */
static inline struct @vector @or_else(struct @vector a, struct @vector other) {
  return @is_zero(a) ? other : a;
}
=== where_any
/* 0 where the first vector is 0, else the second. */
static inline struct @vector @where_any(struct @vector any, struct @vector a) {
  return @is_zero(any) ? any : a;
}
=== over_longest
/* A vector over a length; 0 stays 0. */
static inline struct @vector @over_longest(struct @vector a, @real longest) {
  return longest > 0 ? @over(a, longest) : a;
}
=== left_at
/* What a distance leaves of a light with the attenuation c + l d + q d d. */
static inline @real @left_at(@real distance, @real c, @real l, @real q) {
  return 1 / @larger(c + distance * (l + distance * q), 1);
}
=== reciprocal
/* 1/steps, 0 for none. */
static inline @real @reciprocal(@real steps) { return steps > 0 ? 1 / steps : 0; }
=== per_step
/* What a change along the whole span is from pixel to pixel. */
static inline @real @per_step(@real change, @real steps) { return change / @larger(steps, 1); }
=== vector_per_step
static inline struct @vector @vector_per_step(struct @vector change, @real steps) {
  return @over(change, @larger(steps, 1));
}
=== from
/* What is used in spans of so many steps and more. */
static inline @real @from(@real least, @real steps, @real x) { return steps >= least ? x : 0; }
=== cosine
/* A cosine, which rounding has made no larger than 1. */
static inline @real @cosine(@real x) { return x < -1 ? -1 : x > 1 ? 1 : x; }
=== share
/* A number, made no less than 0 and no more than 1. */
static inline @real @share(@real x) { return x < 0 ? 0 : x > 1 ? 1 : x; }
=== log2
/* The base-2 logarithm of a whole number, rounded down. */
static inline @real @log2(@real whole) {
  @real log = 0;
  for (; whole >= 2; whole /= 2) log += 1;
  return log;
}
=== halfway
/* H = (L + V)/|L + V|; 0 where L = -V. */
static inline struct @vector @halfway(struct @vector light) {
  return @unit(@plus(light, @eye()));
}
=== lengthened
/* h (1 + (y + y^2)/2) with y = 1 - h.h: of about unit length. */
static inline struct @vector @lengthened(struct @vector h) {
  const @real y = 1 - @dot(h, h);
  return @times(h, 1 + (y + y * y) / 2);
}
=== where_not_zero
/* A number; 0 where a vector is 0. */
static inline @real @where_not_zero(struct @vector any, @real x) { return @is_zero(any) ? 0 : x; }
=== spot
/* Warn's factor max(-L.axis, 0)^exponent of a spot; 0 where there is no L. */
static inline @real @spot(struct @vector light, struct @vector axis, @real exponent) {
  const @real base = @share(-@dot(light, axis));
  return @is_zero(light) ? 0 : (@real)pow((double)base, (double)exponent);
}
=== light_dot_view
/* L.V; 1 where the span has no normal, which leaves no highlight. */
static inline @real @light_dot_view(struct @vector normal, struct @vector light) {
  return @is_zero(normal) ? 1 : @dot(light, @eye());
}
=== across_any
/* A unit vector across another. */
static inline struct @vector @across_any(struct @vector a) {
  const @real sign = (@real)copysign(1, (double)a.z);
  const @real p = -1 / (sign + a.z);
  const struct @vector v = {a.x * a.y * p, sign + a.y * a.y * p, -a.y};
  return v;
}
=== bisector
/* The unit vector half-way between two; 0 where they are opposite. */
static inline struct @vector @bisector(struct @vector a, struct @vector b) {
  const struct @vector none = {0, 0, 0};
  const struct @vector sum = @plus(a, b);
  const @real length = @length(sum);
  return length > (@real)(1.0 / 1048576) ? @times(sum, 1 / length) : none;
}
=== fixed_normal
/* The polygon's normal where it is less than 90 degrees from both, else the bisector. */
static inline struct @vector @fixed_normal(
    struct @vector a, struct @vector b, struct @vector facet) {
  const @real least = (@real)(1.0 / 1048576);
  const bool serves = @dot(a, facet) > least && @dot(b, facet) > least;
  return serves ? facet : @bisector(a, b);
}
=== serves
/* Whether an axis is less than 90 degrees from both ends. */
static inline bool @serves(struct @vector axis, struct @vector a, struct @vector b) {
  return @dot(axis, a) > 0 && @dot(axis, b) > 0;
}
=== wrap_axis
/* What unit vectors from a to b are wrapped around: the preferred vector where it serves, or the
   bisector, or a vector across. */
static inline struct @vector @wrap_axis(
    struct @vector a, struct @vector b, struct @vector preferred) {
  const struct @vector middle = @unit(@plus(a, b));
  if (@is_zero(a) || @serves(preferred, a, b)) return @where_any(a, preferred);
  return @serves(middle, a, b) ? middle : @across_any(a);
}
=== wrap_bisector
static inline struct @vector @wrap_bisector(struct @vector a, struct @vector b) {
  const struct @vector none = {0, 0, 0};
  return @wrap_axis(a, b, none);
}
=== follows
/* Whether normals follow: up to 30 degrees, or up to 120 in many steps. */
static inline @real @follows(struct @vector a, struct @vector b, @real steps) {
  const double cosine = (double)(@dot(a, b) / @root(@dot(a, a) * @dot(b, b)));
  const double clamped = cosine < -1 ? -1 : cosine > 1 ? 1 : cosine;
  const double degrees = acos(clamped) * (180 / 3.14159265358979323846);
  return degrees <= 30 || (degrees <= 120 && steps >= 16) ? 1 : 0;
}
=== where_true
static inline struct @vector @where_true(
    @real flag, struct @vector a, struct @vector other) {
  return flag > 0 ? a : other;
}
=== across
/* T, the unit vector across a towards b, whose cross product is `axis`. */
static inline struct @vector @across(
    struct @vector a, struct @vector b, struct @vector axis) {
  const struct @vector none = {0, 0, 0};
  const struct @vector towards = @unit(@cross(axis, a));
  if (!@is_zero(towards)) return towards;
  return @dot(a, b) < 0 ? @across_any(a) : none;
}
=== angle
/* The angle between a and b, whose cross product is `axis`. */
static inline @real @angle(struct @vector a, struct @vector b, struct @vector axis) {
  return (@real)atan2((double)@length(axis), (double)@dot(a, b));
}
=== sin
static inline @real @sin(@real x) { return (@real)sin((double)x); }
=== cos
static inline @real @cos(@real x) { return (@real)cos((double)x); }
=== at_share
/* The unit normal at a share of an arc, 0 to 1, from a to b. */
static inline struct @vector @at_share(
    struct @vector a, struct @vector b, struct @vector across, @real angle, @real share) {
  const @real turn = share * angle;
  if (share <= 0) return a;
  return share >= 1 ? b : @plus(@times(a, @cos(turn)), @times(across, @sin(turn)));
}
=== slerp
/* The unit normal at a share of the way from a to b, 0 to 1; where one of them is 0, the other. */
static inline struct @vector @slerp(struct @vector a, struct @vector b, @real share) {
  const struct @vector start = @or_else(a, b);
  const struct @vector end = @or_else(b, a);
  const struct @vector axis = @cross(start, end);
  if (share <= 0) return start;
  return @at_share(start, end, @across(start, end, axis), @angle(start, end, axis), share);
}
=== on_edge
/* The unit normal on an edge of a triangle, at barycentric weights of which one is 0, by slerp. */
static inline struct @vector @on_edge(
    struct @vector a, struct @vector b, struct @vector c, const @real weights[3]) {
  const @real share = weights[1] > 0 ? weights[1] / (weights[0] + weights[1]) : 0;
  return @slerp(@slerp(a, b, share), c, weights[2]);
}
=== is_narrow
/* Below 10 degrees normals are interpolated linearly. */
static inline bool @is_narrow(@real angle) {
  return angle < (@real)(10.0 * (3.14159265358979323846 / 180.0));
}
=== is_wide
/* From 170 degrees on the frame is orthonormal. */
static inline bool @is_wide(@real angle) {
  return angle >= (@real)(170.0 * (3.14159265358979323846 / 180.0));
}
=== turn_cosine
static inline @real @turn_cosine(@real angle, @real turn) {
  return @is_narrow(angle) ? 1 : @cos(turn);
}
=== turn_sine
static inline @real @turn_sine(@real angle, @real turn, @real linear) {
  return @is_narrow(angle) ? linear : @sin(turn);
}
=== rising_cosine
static inline @real @rising_cosine(@real angle) {
  return @is_narrow(angle) || @is_wide(angle) ? 1 : 1 / @sin(angle);
}
=== falling_cosine
static inline @real @falling_cosine(@real angle) {
  if (@is_narrow(angle)) return 1;
  return @is_wide(angle) ? 0 : @cos(angle) / @sin(angle);
}
=== unless_wide
static inline struct @vector @unless_wide(
    @real angle, struct @vector a, struct @vector other) {
  return @is_wide(angle) ? other : a;
}
=== turn_axis
/* The rotation that brings a unit vector to the eye's, as a quaternion: its x, y and z. */
static inline struct @vector @turn_axis(struct @vector from) {
  const struct @vector none = {0, 0, 0};
  const @real dot = @dot(from, @eye());
  const struct @vector c = @cross(from, @eye());
  const @real w = 1 + dot;
  if (dot > 1 - 2 * (@real)2.220446049250313e-16) return none;
  if (dot < -(1 - 2 * (@real)2.220446049250313e-16)) return @across_any(from);
  return @times(c, 1 / @root(c.x * c.x + c.y * c.y + c.z * c.z + w * w));
}
=== turn_part
/* The same, its real part. */
static inline @real @turn_part(struct @vector from) {
  const @real dot = @dot(from, @eye());
  const struct @vector c = @cross(from, @eye());
  const @real w = 1 + dot;
  if (dot > 1 - 2 * (@real)2.220446049250313e-16) return 1;
  if (dot < -(1 - 2 * (@real)2.220446049250313e-16)) return (@real)6.123233995736766e-17;
  return w * (1 / @root(c.x * c.x + c.y * c.y + c.z * c.z + w * w));
}
=== turned
/* A vector, rotated by a quaternion. */
static inline struct @vector @turned(struct @vector axis, @real part, struct @vector a) {
  const struct @vector along = @times(axis, @dot(a, axis) * 2);
  const struct @vector own = @times(a, part * part - @dot(axis, axis));
  return @plus(@plus(own, along), @times(@cross(axis, a), part * 2));
}
=== weighted
/* What is linear in a triangle, from its corners' vectors and barycentric weights. */
static inline struct @vector @weighted(
    struct @vector a, struct @vector b, struct @vector c, const @real weights[3]) {
  return @plus(@plus(@times(a, weights[0]), @times(b, weights[1])), @times(c, weights[2]));
}
=== reciprocal_length
static inline @real @reciprocal_length(struct @vector a) { return 1 / @length(a); }
=== interpolated
/* What is linear in a triangle, from its values at the vertices and barycentric weights. */
static inline @real @interpolated(const @real at_vertices[3], const @real weights[3]) {
  return weights[0] * at_vertices[0] + weights[1] * at_vertices[1] + weights[2] * at_vertices[2];
}
=== lambert
/* max(N.L, 0) of a unit normal. */
static inline @real @lambert(const @real normal[3], const @real direction[3]) {
  return @larger(@dot(@load(normal), @load(direction)), 0);
}
=== highlight
/* max(R.L, 0)^n of a unit normal with R = 2(N.V)N - V; 0 where there is no normal. */
static inline @real @highlight(
    const @real normal[3], const @real direction[3], @real shininess) {
  const struct @vector n = @load(normal);
  const struct @vector eye = @eye();
  const struct @vector reflected = @minus(@times(n, 2 * @dot(n, eye)), eye);
  const @real base = @share(@dot(reflected, @load(direction)));
  return @is_zero(n) ? 0 : (@real)pow((double)base, (double)shininess);
}
=== lobe
/* Lyon's f_k(n/2 D.D) of a unit normal, with D = R - L and R = 2(N.V)N - V; 0 where there is no
   normal. f_k(x) = (1 - x/2^k)^(2^k), 0 from x = 2^k on; k is the number of squarings, 0 to 4. */
static inline @real @lobe(
    const @real normal[3], const @real direction[3], @real shininess, int squarings) {
  const struct @vector n = @load(normal);
  const struct @vector eye = @eye();
  const struct @vector reflected = @minus(@times(n, 2 * @dot(n, eye)), eye);
  const struct @vector d = @minus(reflected, @load(direction));
  const @real factors = (@real)(1 << squarings);
  @real shape = @larger(1 - shininess * @dot(d, d) / (2 * factors), 0);
  for (; squarings > 0; --squarings) shape *= shape;
  return @is_zero(n) ? 0 : shape;
}
=== rational_angle
/* The angle of a vertex's cone in quarter turns, from the smallest cosine between its axis and the
   normal of a face around the vertex. */
static inline @real @rational_angle(@real cosine) {
  const @real m = @share(cosine);
  const @real excess = (@real)0.03632 * (1 - m) * (1 - m);
  return (@real)acos((double)m) * (@real)0.63661977236758134308 * (1 + excess);
}
=== trigonometric_angle
/* The angle of a vertex's cone in quarter turns, from the smallest cosine between its axis and the
   normal of a face around the vertex. */
static inline @real @trigonometric_angle(@real cosine) {
  const @real m = @share(cosine);
  const @real excess = (@real)0.06097 * (1 - m);
  return (@real)acos((double)m) * (@real)0.63661977236758134308 * (1 + excess);
}
