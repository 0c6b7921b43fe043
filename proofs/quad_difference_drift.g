# Paper 003 with 2A kept in a register: quad_difference.
#
# Proves: rounding I(0), d(0) and 2A to S9.26 moves pixel t <= 2047 by at most 0.0157 codes, which is
# QuadDifference::kContract.max_error_ulp. T stands for t (t - 1)/2.
@near = fixed<-26, ne>;
s = near(S);
d = near(D);
c = near(C);
pixel = s + t * d + T * c;
ideal = S + t * D + T * C;
{ t in [0, 2047] /\ T in [0, 2094081] /\ S in [-1024, 1024] /\ D in [-1024, 1024] /\ C in [-1024, 1024]
  -> pixel - ideal in [-0.0157, 0.0157] }
pixel - ideal -> (s - S) + t * (d - D) + T * (c - C);
