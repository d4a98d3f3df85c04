\\ The number of local maxima of one G_i^k by its gaps and its slope ratio p/q, exactly, with polsturm: the same
\\ decision as Monotonicity::local_maxima, by three routes. compare.sh runs it.

\\ The distances of span s (from 1): knots before from t_s down, knots after from t_{s+1} up.
before(g, s) = { my(d = vector(s)); for (a = 2, s, d[a] = d[a-1] + g[s-a+1]); Vecrev(d) };
after(g, s) = { my(d = vector(#g-s+1)); for (b = 2, #d, d[b] = d[b-1] + g[s+b-1]); d };

\\ P and Q in the variable u from 0 to infinity, x = (t_s + u t_{s+1})/(1 + u), without fractions: G_i^d is kept
\\ as a numerator over a known product of linear factors L[a,b], the denominators of the weights.
numerators(g, p, q, s) =
{
  my(k = #g-1, B = before(g, s), A = after(g, s), h = g[s], n = #B, m = #A, R, F, L, C, W, G, H, i, e, v);
  R = vector(n, a, p*(B[a] + (B[a]+h)*'u));
  F = vector(m, b, q*((A[b]+h) + A[b]*'u));
  L = matrix(n, m, a, b, R[a]+F[b]);
  \\ C[b][c]: the product of the last c-1 entries of column b. W[a][c]: of the first c-1 entries of row a.
  C = vector(m, b, v = vector(n+1, c, 1); for (c = 2, n+1, v[c] = v[c-1]*L[n-c+2,b]); v);
  W = vector(n, a, v = vector(m+1, c, 1); for (c = 2, m+1, v[c] = v[c-1]*L[a,c-1]); v);
  G = vector(k+1); G[s] = 1;
  for (d = 1, k,
    H = vector(k+1);
    for (i = max(1, s-d+1), min(s, k+2-d),
      e = i+d-s;                        \\ t_{i+d} is F[e]
      if (e < m, H[i] += G[i]*R[i]*C[e+1][s-i+1]);
      if (i > 1, H[i-1] += G[i]*F[e]*W[i-1][e]));
    G = H);
  [G[1], prod(b = 1, m-1, C[b][n+1])*C[m][n]];
};

\\ The same function as a quotient in a variable x, by the recursion as it is written.
quotient(T, k, r, s, x) =
{
  my(G = vector(k+1), H, w = (a, b) -> r*(x-T[a])/(r*(x-T[a]) + T[b]-x)); G[s] = 1;
  for (d = 1, k,
    H = vector(k+1);
    for (i = max(1, s-d), min(s, k+1-d),
      if (G[i], H[i] += w(i, i+d)*G[i]);
      if (G[i+1], H[i] += (1-w(i+1, i+d+1))*G[i+1]));
    G = H);
  G[1];
};

\\ The numerator of the derivative of P/Q, for [P, Q].
slope(f) = f[1]'*f[2] - f[1]*f[2]';

\\ The signs of N between its sign changes in (a, b), for N(a), N(b) not 0: none or one root shows at the ends,
\\ and more are separated by halving. `cut` is a point between.
signs(N, a, b, left, right, cut) =
{
  my(n = polsturm(N, [a, b]), c, sc);
  if (n == 0, return([left]));
  if (n == 1, return(if (left == right, [left], [left, right])));
  c = cut(a, b); while (!(sc = sign(subst(N, variable(N), c))), c = cut(c, b));
  concat(signs(N, a, c, left, sc, cut), signs(N, c, b, sc, right, cut));
};
in_u(a, b) = if (b == +oo, 2*a+1, (a+b)/2);
in_x(a, b) = (a+b)/2;

\\ On (0, oo), a root at 0 taken out.
signs_u(N) =
{
  my(v);
  if (!N, return([]));
  N = N/content(N)/'u^valuation(N, 'u);
  signs(N, 0, +oo, sign(polcoef(N, 0)), sign(pollead(N)), in_u);
};

\\ On (a, b), roots at a and b taken out: the sign of N/(x-a)^i/(b-x)^j.
signs_x(N, a, b) =
{
  my(l, r);
  if (!N, return([]));
  N = N/content(N);
  while (!(l = subst(N, 'x, a)), N = N\('x-a));
  while (!(r = subst(N, 'x, b)), N = N\(b-'x));
  signs(N, a, b, sign(l), sign(r), in_x);
};

by_numerators(g, p, q, s) = signs_u(slope(numerators(g, p, q, s)));
knots(g) = { my(T = vector(#g+1)); for (i = 1, #g, T[i+1] = T[i]+g[i]); T };
by_quotients(g, p, q, s) =
{
  my(T = knots(g), f = quotient(T, #g-1, p/q, s, 'x));
  signs_x(slope([numerator(f), denominator(f)]), T[s], T[s+1]);
};
by_quotients_in_u(g, p, q, s) =
{
  my(T = knots(g), f = quotient(T, #g-1, p/q, s, (T[s] + 'u*T[s+1])/(1+'u)));
  signs_u(slope([numerator(f), denominator(f)]));
};

maxima(g, p, q, route) =
{
  my(all = List(), n = 0);
  for (s = 1, #g, if (g[s], foreach(route(g, p, q, s), sg, listput(all, sg))));
  for (i = 2, #all, if (all[i-1] > 0 && all[i] < 0, n++));
  n;
};

run(folder, name, route) =
{
  my(cases = readvec(Str(folder, "/cases")), t = getwalltime(), counts);
  counts = [maxima(c[1], c[2], c[3], route) | c <- cases];
  t = getwalltime() - t;
  system(Str("rm -f ", folder, "/", name));
  foreach(counts, c, write(Str(folder, "/", name), c));
  print(t/1000.);
};
