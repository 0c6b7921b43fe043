# Paper 000 (7), slerp_paper with one lane and F = 38, 2048 pixels: to first order every step's
# rounding of the sum (2^-39) and of the factor c = 2 - kappa (2^-39 |N|) enters the second
# difference, whose Green's function is at most the number of steps; T = t (t - 1)/2 such steps.
#
# Proves: T (2^-39 + 2^-39) + seeds <= 2098200 2^-38, SlerpPaper::kContract.max_error_ulp, with N up to
# 1 + 2^-16 for the erring values; f: kappa's own
# rounding, U1.28 4^-10, as small turns have it; larger ones have a smaller Green's function. Seeds: N(0) by 2^-39 and N(1) - N(0) by 2^-39 a step.
r = fixed<-38, ne>(P) - P;
c = fixed<-38, ne>(C) - C + f;
u = fixed<-38, ne>(S) - S;
v = fixed<-38, ne>(D) - D;
drift = T * (r + c * n) + u + t * v;
{ t in [0, 2047] /\ T in [0, 2094081] /\ P in [-2, 2] /\ C in [0, 2] /\ S in [-1, 1] /\ D in [-1, 1]
  /\ |n| <= 65537b-16 /\ |f| <= 1b-49
  -> drift in [-2098200b-38, 2098200b-38] }
