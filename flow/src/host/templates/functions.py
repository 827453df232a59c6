=== eye
def @eye():
    """V, the direction to an eye at infinity."""
    return np.array([[0.0], [0.0], [1.0]])
=== component_x
def @component_x(a):
    return a[0]
=== component_y
def @component_y(a):
    return a[1]
=== component_z
def @component_z(a):
    return a[2]
=== dot
def @dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
=== plus
def @plus(a, b):
    return a + b
=== minus
def @minus(a, b):
    return a - b
=== negative
def @negative(a):
    return -a
=== times
def @times(a, factor):
    return a * factor
=== over
def @over(a, divisor):
    return a / divisor
=== cross
def @cross(a, b):
    return np.array([
        a[1] * b[2] - b[1] * a[2],
        a[2] * b[0] - b[2] * a[0],
        a[0] * b[1] - b[0] * a[1],
    ])
=== root
def @root(x):
    return np.sqrt(x)
=== length
def @length(a):
    return np.sqrt(@dot(a, a))
=== larger
def @larger(a, b):
    return np.maximum(a, b)
=== is_zero
def @is_zero(a):
    return (a[0] == 0) & (a[1] == 0) & (a[2] == 0)
=== unit
def @unit(a):
    """A vector of length 1 in the direction of another; 0 where that has none."""
    factor = 1 / @length(a)
    return np.where(np.isfinite(factor) & (factor > 0), a * factor, 0.0)
=== or_else
def @or_else(a, other):
    """A vector, or another one where it is 0."""
    return np.where(@is_zero(a), other, a)
=== where_any
def @where_any(anything, a):
    """0 where the first vector is 0, else the second."""
    return np.where(@is_zero(anything), 0.0, a)
=== over_longest
def @over_longest(a, longest):
    """A vector over a length; 0 stays 0."""
    return np.where(longest > 0, a / longest, a)
=== left_at
def @left_at(distance, c, l, q):
    """What a distance leaves of a light with the attenuation c + l d + q d d."""
    return 1 / np.maximum(c + distance * (l + distance * q), 1)
=== reciprocal
def @reciprocal(steps):
    """1/steps, 0 for none."""
    return np.where(steps > 0, 1 / steps, 0.0)
=== per_step
def @per_step(change, steps):
    """What a change along the whole span is from pixel to pixel."""
    return change / np.maximum(steps, 1)
=== vector_per_step
def @vector_per_step(change, steps):
    return change / np.maximum(steps, 1)
=== from
def @from(least, steps, x):
    """What is used in spans of so many steps and more."""
    return np.where(steps >= least, x, 0.0)
=== cosine
def @cosine(x):
    """A cosine, which rounding has made no larger than 1."""
    return np.clip(x, -1.0, 1.0)
=== share
def @share(x):
    return np.clip(x, 0.0, 1.0)
=== log2
def @log2(whole):
    """The base-2 logarithm of a whole number, rounded down."""
    return np.frexp(whole)[1] - 1.0
=== halfway
def @halfway(light):
    """H = (L + V)/|L + V|; 0 where L = -V."""
    return @unit(light + @eye())
=== lengthened
def @lengthened(h):
    """h (1 + (y + y^2)/2) with y = 1 - h.h: of about unit length."""
    y = 1 - @dot(h, h)
    return h * (1 + (y + y * y) / 2)
=== where_not_zero
def @where_not_zero(anything, x):
    """A number; 0 where a vector is 0."""
    return np.where(@is_zero(anything), 0.0, x)
=== spot
def @spot(light, axis, exponent):
    """Warn's factor max(-L.axis, 0)^exponent of a spot; 0 where there is no L."""
    return np.where(@is_zero(light), 0.0, @share(-@dot(light, axis)) ** exponent)
=== light_dot_view
def @light_dot_view(normal, light):
    """L.V; 1 where the span has no normal, which leaves no highlight."""
    return np.where(@is_zero(normal), 1.0, light[2])
=== across_any
def @across_any(a):
    """A unit vector across another."""
    sign = np.copysign(1.0, a[2])
    p = -1 / (sign + a[2])
    return np.array([a[0] * a[1] * p, sign + a[1] * a[1] * p, -a[1]])
=== bisector
def @bisector(a, b):
    """The unit vector half-way between two; 0 where they are opposite."""
    total = a + b
    length = @length(total)
    return np.where(length > 1 / 1048576, total * (1 / length), 0.0)
=== fixed_normal
def @fixed_normal(a, b, facet):
    """The polygon's normal where it is less than 90 degrees from both, else the bisector."""
    least = 1 / 1048576
    serves = (@dot(a, facet) > least) & (@dot(b, facet) > least)
    return np.where(serves, facet, @bisector(a, b))
=== serves
def @serves(axis, a, b):
    """Whether an axis is less than 90 degrees from both ends."""
    return (@dot(axis, a) > 0) & (@dot(axis, b) > 0)
=== wrap_axis
def @wrap_axis(a, b, preferred):
    """What unit vectors from a to b are wrapped around: the preferred vector where it serves, or
    the bisector, or a vector across."""
    middle = @unit(a + b)
    middle = np.where(@serves(middle, a, b), middle, @across_any(a))
    return @where_any(a, np.where(@serves(preferred, a, b), preferred, middle))
=== wrap_bisector
def @wrap_bisector(a, b):
    return @wrap_axis(a, b, np.zeros((3, 1)))
=== follows
def @follows(a, b, steps):
    """Whether normals follow: up to 30 degrees, or up to 120 in many steps."""
    cosine = @dot(a, b) / np.sqrt(@dot(a, a) * @dot(b, b))
    degrees = np.arccos(np.clip(cosine, -1.0, 1.0)) * (180 / np.pi)
    return np.where((degrees <= 30) | ((degrees <= 120) & (steps >= 16)), 1.0, 0.0)
=== where_true
def @where_true(flag, a, other):
    return np.where(flag > 0, a, other)
=== across
def @across(a, b, axis):
    """T, the unit vector across a towards b, whose cross product is `axis`."""
    towards = @unit(@cross(axis, a))
    opposite = np.where(@dot(a, b) < 0, @across_any(a), 0.0)
    return np.where(@is_zero(towards), opposite, towards)
=== angle
def @angle(a, b, axis):
    """The angle between a and b, whose cross product is `axis`."""
    return np.arctan2(@length(axis), @dot(a, b))
=== sin
def @sin(x):
    return np.sin(x)
=== cos
def @cos(x):
    return np.cos(x)
=== at_share
def @at_share(a, b, across, angle, share):
    """The unit normal at a share of an arc, 0 to 1, from a to b."""
    turn = share * angle
    between = a * np.cos(turn) + across * np.sin(turn)
    return np.where(share <= 0, a, np.where(share >= 1, b, between))
=== slerp
def @slerp(a, b, share):
    """The unit normal at a share of the way from a to b, 0 to 1; where one of them is 0, the other."""
    start, end = @or_else(a, b), @or_else(b, a)
    axis = @cross(start, end)
    return @at_share(start, end, @across(start, end, axis), @angle(start, end, axis), share)
=== on_edge
def @on_edge(a, b, c, weights):
    """The unit normal on an edge of a triangle, at barycentric weights of which one is 0, by slerp."""
    share = np.where(weights[1] > 0, weights[1] / (weights[0] + weights[1]), 0.0)
    return @slerp(@slerp(a, b, share), c, weights[2])
=== is_narrow
def @is_narrow(angle):
    """Below 10 degrees normals are interpolated linearly."""
    return angle < 10 * (np.pi / 180)
=== is_wide
def @is_wide(angle):
    """From 170 degrees on the frame is orthonormal."""
    return angle >= 170 * (np.pi / 180)
=== turn_cosine
def @turn_cosine(angle, turn):
    return np.where(@is_narrow(angle), 1.0, np.cos(turn))
=== turn_sine
def @turn_sine(angle, turn, linear):
    return np.where(@is_narrow(angle), linear, np.sin(turn))
=== rising_cosine
def @rising_cosine(angle):
    return np.where(@is_narrow(angle) | @is_wide(angle), 1.0, 1 / np.sin(angle))
=== falling_cosine
def @falling_cosine(angle):
    between = np.where(@is_wide(angle), 0.0, np.cos(angle) / np.sin(angle))
    return np.where(@is_narrow(angle), 1.0, between)
=== unless_wide
def @unless_wide(angle, a, other):
    return np.where(@is_wide(angle), other, a)
=== turn_axis
def @turn_axis(start):
    """The rotation that brings a unit vector to the eye's, as a quaternion: its x, y and z."""
    eye = @eye()
    dot, c = @dot(start, eye), @cross(start, np.broadcast_to(eye, start.shape))
    w = 1 + dot
    turn = c * (1 / np.sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + w * w))
    turn = np.where(dot < -(1 - 2 * 2.220446049250313e-16), @across_any(start), turn)
    return np.where(dot > 1 - 2 * 2.220446049250313e-16, 0.0, turn)
=== turn_part
def @turn_part(start):
    """The same, its real part."""
    eye = @eye()
    dot, c = @dot(start, eye), @cross(start, np.broadcast_to(eye, start.shape))
    w = 1 + dot
    part = w * (1 / np.sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2] + w * w))
    part = np.where(dot < -(1 - 2 * 2.220446049250313e-16), 6.123233995736766e-17, part)
    return np.where(dot > 1 - 2 * 2.220446049250313e-16, 1.0, part)
=== turned
def @turned(axis, part, a):
    """A vector, rotated by a quaternion."""
    along = axis * (@dot(a, axis) * 2)
    own = a * (part * part - @dot(axis, axis))
    across = np.array([
        axis[1] * a[2] - a[1] * axis[2],
        axis[2] * a[0] - a[2] * axis[0],
        axis[0] * a[1] - a[0] * axis[1],
    ])
    return own + along + across * (part * 2)
=== weighted
def @weighted(a, b, c, weights):
    """What is linear in a triangle, from its corners' vectors and barycentric weights."""
    return a * weights[0] + b * weights[1] + c * weights[2]
=== reciprocal_length
def @reciprocal_length(a):
    return 1 / @length(a)
=== interpolated
def @interpolated(at_vertices, weights):
    """What is linear in a triangle, from its values at the vertices and barycentric weights: the
    last axis of both has the vertices."""
    a, w = np.asarray(at_vertices, float), np.asarray(weights, float)
    return w[..., 0] * a[..., 0] + w[..., 1] * a[..., 1] + w[..., 2] * a[..., 2]
=== lambert
def @lambert(normal, direction):
    """max(N.L, 0) of unit normals, whose last axis has x, y and z."""
    return @larger(@dot(_components(normal), _components(direction)), 0.0)
=== highlight
def @highlight(normal, direction, shininess):
    """max(R.L, 0)^n of unit normals with R = 2(N.V)N - V; 0 where there is no normal."""
    n, l = _components(normal), _components(direction)
    eye = np.array([0.0, 0.0, 1.0]).reshape((3,) + (1,) * (n.ndim - 1))
    reflected = n * (2 * n[2]) - eye
    return np.where(@is_zero(n), 0.0, @share(@dot(reflected, l)) ** shininess)
=== lobe
def @lobe(normal, direction, shininess, squarings):
    """Lyon's f_k(n/2 D.D) of unit normals, with D = R - L and R = 2(N.V)N - V; 0 where there is no
    normal. f_k(x) = (1 - x/2^k)^(2^k), 0 from x = 2^k on; k is the number of squarings, 0 to 4."""
    n, l = _components(normal), _components(direction)
    eye = np.array([0.0, 0.0, 1.0]).reshape((3,) + (1,) * (n.ndim - 1))
    d = n * (2 * n[2]) - eye - l
    shape = @larger(1 - shininess * @dot(d, d) / (2 * 2.0**squarings), 0.0)
    for _ in range(squarings):
        shape = shape * shape
    return np.where(@is_zero(n), 0.0, shape)
=== rational_angle
def @rational_angle(cosine):
    """The angles of vertices' cones in quarter turns, from the smallest cosine between an axis and
    the normal of a face around the vertex."""
    m = @share(cosine)
    return np.arccos(m) * (2 / np.pi) * (1 + 0.03632 * (1 - m) * (1 - m))
=== trigonometric_angle
def @trigonometric_angle(cosine):
    """The angles of vertices' cones in quarter turns, from the smallest cosine between an axis and
    the normal of a face around the vertex."""
    m = @share(cosine)
    return np.arccos(m) * (2 / np.pi) * (1 + 0.06097 * (1 - m))
