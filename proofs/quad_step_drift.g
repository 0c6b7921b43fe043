# Paper 003, forms that add differences: what the seeds' rounding does to pixel t of a span.
#
# Proves: |s + t d + t (t - 1)/2 c - (S + t D + t (t - 1)/2 C)| <= 2^-27 (1 + t + t (t - 1))
# and so <= 0.0313 codes at t <= 2047, for seeds of quad_step, quad_segment (I(0), I(1) - I(0), and
# 2A = c twice the rounded A). Constants of the code: IntensityAcc S9.26 in model/shading_types.h;
# the bound is QuadStep::kContract.max_error_ulp = QuadSegment's = 0.0313.
@near = fixed<-26, ne>;
s = near(S);
d = near(D);
a = near(A);
pixel = s + t * d + T * a;
ideal = S + t * D + T * A;
# T stands for t (t - 1), an integer of 0 .. 2047 2046.
{ t in [0, 2047] /\ T in [0, 4188162] /\ S in [-1024, 1024] /\ D in [-1024, 1024] /\ A in [-1024, 1024]
  -> pixel - ideal in [-0.0313, 0.0313] }
pixel - ideal -> (s - S) + t * (d - D) + T * (a - A);
