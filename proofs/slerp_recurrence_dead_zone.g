# slerp_recurrence where its bound is attained: small turns, where only the product's rounding to
# S1.38 counts. Errors of at most 2^-39 a step, summed twice over t = 2047 steps, and the seeds'.
#
# Proves: T 2^-39 + (t + 1) 2^-39 <= 1025 2^-28 with T = t (t + 1)/2, so that
# SlerpRecurrence::kContract.max_error_ulp = 1025 holds for the dead zone at 2048 pixels, with
# kappa below 2^-20, so p = 10 and the operand's share kappa 2^-29 a step below 2^-49.
e = fixed<-38, ne>(B) - B;      # one step's product
u = fixed<-38, ne>(S) - S;      # s(0)
v = fixed<-38, ne>(D) - D;      # d(0)
drift = T * (e + f) + u + t * v;
{ t in [0, 2047] /\ T in [0, 2094081] /\ B in [-1, 1] /\ S in [-1, 1] /\ D in [-1, 1] /\ |f| <= 1b-49
  -> drift in [-1025b-28, 1025b-28] }
