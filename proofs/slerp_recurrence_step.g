# Paper 000 (7), (14) in Reinsch's form: what one step of slerp_recurrence rounds.
#
#   d(t+1) = d(t) - kappa s(t+1);  s to S1.28, the product to S1.38; kappa U1.28 times 4^-p, p = 0
#
# Proves, with kappa in [0, 1], |s| <= 1: |bend - kappa s| <= 2^-29 + 2^-29 + 2^-39, of the operand, of
# kappa itself and of the product. Together the `added` that
# tests/unit/normal/slerp_recurrence_test.cpp carries on with Green's function.
# Constants of the code: kOperandAlign (S1.28), kRoundingShift (S1.38), Kappa::mantissa U1.28.
@operand = fixed<-28, ne>;
@product = fixed<-38, ne>;
k = fixed<-28, ne>(K);
o = operand(s);
bend = product(k * o);
exact = K * s;
{ K in [0, 1] /\ s in [-1, 1]
  -> bend - exact in [-2049b-39, 2049b-39] }
bend - exact -> (product(k * o) - k * o) + k * (o - s) + s * (k - K);
