(* The basis as a race of two clocks, at one point x inside a span, with derivatives carried as pairs
   (value, derivative): pure algebra over any ordered field.
   a n = x - t_(s-n)  (n-th left knot),  b m = t_(s+1+m) - x  (m-th right knot);  a' = 1, b' = -1.
   State (n,m): n left and m right knots passed.  G_i^k of the paper = G (s-i) (k-(s-i)).            *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Race.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variables a b : nat -> R.
Hypothesis a_gt0 : forall n, 0 < a n.
Hypothesis b_gt0 : forall m, 0 < b m.
Hypothesis a_mono : forall n, a n <= a n.+1.
Hypothesis b_mono : forall m, b m <= b m.+1.

(* dual numbers *)
Definition dual := (R * R)%type.
Definition da (f g : dual) : dual := (f.1 + g.1, f.2 + g.2).
Definition dm (f g : dual) : dual := (f.1 * g.1, f.2 * g.1 + f.1 * g.2).

(* w = r a/(r a + b), v = b/(r a + b) and their x-derivatives *)
Definition den n m := r * a n + b m.
Definition w n m : dual := (r * a n / den n m, r * (a n + b m) / den n m ^+ 2).
Definition v n m : dual := (b m / den n m, - (r * (a n + b m) / den n m ^+ 2)).

Lemma den_gt0 n m : 0 < den n m.
Proof. by rewrite addr_gt0 // mulr_gt0. Qed.
Lemma den_neq0 n m : den n m != 0.
Proof. by rewrite gt_eqF ?den_gt0. Qed.

(* G n m: probability that the race visits (n,m) *)
Fixpoint G (n : nat) : nat -> dual :=
  match n with
  | 0 => fix G0 (m : nat) : dual := match m with 0 => (1, 0) | m'.+1 => dm (w 0 m') (G0 m') end
  | n'.+1 => fix Gn (m : nat) : dual :=
      match m with
      | 0 => dm (v n' 0) (G n' 0)
      | m'.+1 => da (dm (w n'.+1 m') (Gn m')) (dm (v n' m'.+1) (G n' m'.+1))
      end
  end.
Definition F n m := dm (w n m) (G n m).   (* leaves to the right *)
Definition H n m := dm (v n m) (G n m).   (* leaves to the left  *)

Lemma G00 : G 0 0 = (1, 0). Proof. by []. Qed.
Lemma G0S m : G 0 m.+1 = F 0 m. Proof. by []. Qed.
Lemma GS0 n : G n.+1 0 = H n 0. Proof. by []. Qed.
Lemma GSS n m : G n.+1 m.+1 = da (F n.+1 m) (H n m.+1). Proof. by []. Qed.

Lemma w1_gt0 n m : 0 < (w n m).1.
Proof. by rewrite /w /= divr_gt0 ?den_gt0 // mulr_gt0. Qed.
Lemma v1_gt0 n m : 0 < (v n m).1.
Proof. by rewrite /v /= divr_gt0 ?den_gt0. Qed.

Lemma G1_gt0 n m : 0 < (G n m).1.
Proof.
elim: n m => [|n IHn] m.
  elim: m => [|m IHm]; first by rewrite G00 /= ltr01.
  by rewrite G0S /F /= mulr_gt0 ?w1_gt0.
elim: m => [|m IHm]; first by rewrite GS0 /H /= mulr_gt0 ?v1_gt0.
by rewrite GSS /F /H /= addr_gt0 // mulr_gt0 ?w1_gt0 ?v1_gt0.
Qed.
Lemma F1_gt0 n m : 0 < (F n m).1. Proof. by rewrite mulr_gt0 ?w1_gt0 ?G1_gt0. Qed.
Lemma H1_gt0 n m : 0 < (H n m).1. Proof. by rewrite mulr_gt0 ?v1_gt0 ?G1_gt0. Qed.

(* f << g : g/f is non-decreasing at x *)
Definition lr (f g : dual) := 0 <= f.1 * g.2 - f.2 * g.1.

Lemma lr_trans (g f h : dual) : 0 < g.1 -> 0 <= f.1 -> 0 <= h.1 -> lr f g -> lr g h -> lr f h.
Proof.
rewrite /lr => g0 f0 h0 fg gh; rewrite -(pmulr_rge0 _ g0).
have -> : g.1 * (f.1 * h.2 - f.2 * h.1) =
   f.1 * (g.1 * h.2 - g.2 * h.1) + h.1 * (f.1 * g.2 - f.2 * g.1) by ring.
by rewrite addr_ge0 // mulr_ge0.
Qed.

Lemma lr_addl (f f' g : dual) : lr f g -> lr f' g -> lr (da f f') g.
Proof.
rewrite /lr /= => h1 h2.
have -> : (f.1 + f'.1) * g.2 - (f.2 + f'.2) * g.1 =
  (f.1 * g.2 - f.2 * g.1) + (f'.1 * g.2 - f'.2 * g.1) by ring.
by rewrite addr_ge0.
Qed.
Lemma lr_addr (f g g' : dual) : lr f g -> lr f g' -> lr f (da g g').
Proof.
rewrite /lr /= => h1 h2.
have -> : f.1 * (g.2 + g'.2) - f.2 * (g.1 + g'.1) =
  (f.1 * g.2 - f.2 * g.1) + (f.1 * g'.2 - f.2 * g'.1) by ring.
by rewrite addr_ge0.
Qed.
Lemma lr_mul (f g u z : dual) : 0 <= f.1 -> 0 <= g.1 -> 0 <= u.1 -> 0 <= z.1 ->
  lr f g -> lr u z -> lr (dm f u) (dm g z).
Proof.
rewrite /lr /= => f0 g0 u0 z0 h1 h2.
have -> : f.1 * u.1 * (g.2 * z.1 + g.1 * z.2) - (f.2 * u.1 + f.1 * u.2) * (g.1 * z.1) =
  u.1 * z.1 * (f.1 * g.2 - f.2 * g.1) + f.1 * g.1 * (u.1 * z.2 - u.2 * z.1) by ring.
by rewrite addr_ge0 // mulr_ge0 // mulr_ge0.
Qed.
Lemma lr_refl f : lr f f. Proof. by rewrite /lr mulrC subrr. Qed.
Lemma lr_scale (u f g : dual) : 0 <= u.1 -> 0 <= f.1 -> 0 <= g.1 -> lr f g -> lr (dm u f) (dm u g).
Proof. by move=> u0 f0 g0 h; apply: lr_mul => //; apply: lr_refl. Qed.

Lemma dmA (f g h : dual) : dm f (dm g h) = dm (dm f g) h.
Proof. by congr (_, _); rewrite /=; ring. Qed.
Lemma dmDr (f g h : dual) : dm f (da g h) = da (dm f g) (dm f h).
Proof. by congr (_, _); rewrite /=; ring. Qed.

(* step (a): w(n+1,m) v(n,m) << v(n,m+1) w(n,m) *)
Lemma step_a n m : lr (dm (w n.+1 m) (v n m)) (dm (v n m.+1) (w n m)).
Proof.
set a0 := a n; set a1 := a n.+1; set b0 := b m; set b1 := b m.+1.
have e1 := den_neq0 n.+1 m; have e2 := den_neq0 n m; have e3 := den_neq0 n m.+1.
pose T := (a1 - a0) * (b0 * b1) ^+ 2
  + r * ((a0 * a1 ^+ 2 * b1 ^+ 2 - a0 ^+ 2 * a1 * b0 ^+ 2) + (a1 ^+ 2 * b0 * b1 ^+ 2 - a0 ^+ 2 * b0 ^+ 2 * b1))
  + r ^+ 2 * ((a0 * a1) ^+ 2 * (b1 - b0)).
rewrite /lr.
have -> : (dm (w n.+1 m) (v n m)).1 * (dm (v n m.+1) (w n m)).2 -
          (dm (w n.+1 m) (v n m)).2 * (dm (v n m.+1) (w n m)).1 =
   r ^+ 2 * T / (den n.+1 m * den n m * den n m.+1) ^+ 2.
  move: e1 e2 e3; rewrite /w /v /T /den /= -/a0 -/a1 -/b0 -/b1 => e1 e2 e3.
  by field; rewrite e1 e2 e3.
have a0p : 0 < a0 := a_gt0 n. have b0p : 0 < b0 := b_gt0 m.
have a1p : 0 < a1 := a_gt0 n.+1. have b1p : 0 < b1 := b_gt0 m.+1.
have aa : a0 <= a1 := a_mono n. have bb : b0 <= b1 := b_mono m.
apply: divr_ge0; last by rewrite exprn_ge0 // !mulr_ge0 // ltW ?den_gt0.
apply: mulr_ge0; first by rewrite exprn_ge0 // ltW.
apply: addr_ge0; first apply: addr_ge0.
- by rewrite mulr_ge0 ?subr_ge0 // exprn_ge0 // mulr_ge0 // ltW.
- apply: mulr_ge0; first exact: ltW.
  apply: addr_ge0; rewrite subr_ge0.
  + have -> : a0 ^+ 2 * a1 * b0 ^+ 2 = a0 * a1 * (a0 * b0 ^+ 2) by ring.
    have -> : a0 * a1 ^+ 2 * b1 ^+ 2 = a0 * a1 * (a1 * b1 ^+ 2) by ring.
    rewrite ler_wpmul2l ?mulr_ge0 ?(ltW a0p) ?(ltW a1p) //.
    by rewrite ler_pmul ?(ltW a0p) ?exprn_ge0 ?(ltW b0p) // ler_pexpn2r // nnegrE ltW.
  + have -> : a0 ^+ 2 * b0 ^+ 2 * b1 = b0 * b1 * (a0 ^+ 2 * b0) by ring.
    have -> : a1 ^+ 2 * b0 * b1 ^+ 2 = b0 * b1 * (a1 ^+ 2 * b1) by ring.
    rewrite ler_wpmul2l ?mulr_ge0 ?(ltW b0p) ?(ltW b1p) //.
    by rewrite ler_pmul ?exprn_ge0 ?(ltW a0p) ?(ltW b0p) // ler_pexpn2r // nnegrE ltW.
- by rewrite mulr_ge0 ?exprn_ge0 ?(ltW r_gt0) // mulr_ge0 ?subr_ge0 // exprn_ge0 // mulr_ge0 // ltW.
Qed.

Lemma WH_ZF n m : lr (dm (w n.+1 m) (H n m)) (dm (v n m.+1) (F n m)).
Proof.
rewrite /H /F !dmA; apply: lr_mul; try exact: lr_refl; try exact: step_a.
- by rewrite /= mulr_ge0 // ltW ?w1_gt0 ?v1_gt0.
- by rewrite /= mulr_ge0 // ltW ?w1_gt0 ?v1_gt0.
- by rewrite ltW ?G1_gt0.
- by rewrite ltW ?G1_gt0.
Qed.

Let dpos f g : 0 < f.1 -> 0 < g.1 -> 0 < (dm f g).1. Proof. by move=> *; rewrite mulr_gt0. Qed.
Let F0 n m : 0 <= (F n m).1. Proof. exact: ltW (F1_gt0 n m). Qed.
Let H0 n m : 0 <= (H n m).1. Proof. exact: ltW (H1_gt0 n m). Qed.
Let w0 n m : 0 <= (w n m).1. Proof. exact: ltW (w1_gt0 n m). Qed.
Let v0 n m : 0 <= (v n m).1. Proof. exact: ltW (v1_gt0 n m). Qed.

(* Theorem D, strong form *)
Theorem strong n m : lr (F n.+1 m) (H n m.+1).
Proof.
have [k] := ubnP (n + m)%N; elim: k n m => // k IH n m; rewrite ltnS => le.
rewrite [F n.+1 m]/F [H n m.+1]/H.
have a1 := WH_ZF n m.
have p1 : 0 < (dm (w n.+1 m) (H n m)).1 by rewrite dpos ?w1_gt0 ?H1_gt0.
have p2 : 0 < (dm (v n m.+1) (F n m)).1 by rewrite dpos ?v1_gt0 ?F1_gt0.
(* F(n+1,m-1) << H(n,m) when m > 0; F(n,m) << H(n-1,m+1) when n > 0 *)
have left_ (f : dual) : lr (dm (w n.+1 m) (H n m)) f -> 0 <= f.1 -> lr (dm (w n.+1 m) (G n.+1 m)) f.
  case: m le IH a1 p1 p2 => [|m'] le IH a1 p1 p2 hf f0; first by rewrite GS0.
  rewrite GSS dmDr; apply: lr_addl => //.
  apply: (lr_trans p1) => //; first by rewrite ltW // dpos ?w1_gt0 ?F1_gt0.
  by apply: lr_scale => //; apply: IH; rewrite -addnS.
apply: left_; last by rewrite ltW // dpos ?v1_gt0 ?G1_gt0.
case: n le IH a1 p1 p2 => [|n'] le IH a1 p1 p2; first by rewrite G0S.
rewrite GSS dmDr; apply: lr_addr => //.
apply: (lr_trans p2) => //; first exact: ltW.
  by rewrite ltW // dpos ?v1_gt0 ?H1_gt0.
by apply: lr_scale => //; apply: IH; rewrite -addSn.
Qed.

(* Theorem D: G_(i+1)/G_i is non-decreasing *)
Theorem G_ratio n m : lr (G n.+1 m) (G n m.+1).
Proof.
have s := strong n m; rewrite /F /H in s.
set W := w n.+1 m in s; set Z := v n m.+1 in s.
have W1 : 0 < W.1 := w1_gt0 _ _. have Z1 : 0 < Z.1 := v1_gt0 _ _.
have W2 : 0 <= W.2.
  by rewrite /W /= divr_ge0 ?exprn_ge0 ?(ltW (den_gt0 _ _)) // mulr_ge0 ?(ltW r_gt0) // addr_ge0 // ltW.
have Z2 : Z.2 <= 0.
  by rewrite /Z /= oppr_le0 divr_ge0 ?exprn_ge0 ?(ltW (den_gt0 _ _)) // mulr_ge0 ?(ltW r_gt0) // addr_ge0 // ltW.
have g1 := G1_gt0 n.+1 m. have g2 := G1_gt0 n m.+1.
move: s; rewrite /lr /=; set f := G n.+1 m in g1 *; set g := G n m.+1 in g2 * => s.
rewrite -(pmulr_rge0 _ (mulr_gt0 W1 Z1)).
have -> : W.1 * Z.1 * (f.1 * g.2 - f.2 * g.1) =
  (W.1 * f.1 * (Z.2 * g.1 + Z.1 * g.2) - (W.2 * f.1 + W.1 * f.2) * (Z.1 * g.1))
  + (f.1 * g.1) * (W.2 * Z.1 - W.1 * Z.2) by ring.
rewrite addr_ge0 // mulr_ge0 ?mulr_ge0 ?(ltW g1) ?(ltW g2) //.
by rewrite subr_ge0 (@le_trans _ _ 0) // ?mulr_ge0_le0 ?(ltW W1) // mulr_ge0 ?(ltW Z1).
Qed.

(* cumulative functions: C n m = P(m right before n left);  monotone in x *)
Fixpoint C (n : nat) : nat -> dual :=
  match n with
  | 0 => fun m => if m is 0 then (1, 0) else (0, 0)
  | n'.+1 => fix Cn (m : nat) : dual :=
      if m is m'.+1 then da (dm (w n' m') (Cn m')) (dm (v n' m') (C n' m'.+1)) else (1, 0)
  end.
Definition ds (f g : dual) : dual := (f.1 - g.1, f.2 - g.2).
Lemma CSS n m : C n.+1 m.+1 = da (dm (w n m) (C n.+1 m)) (dm (v n m) (C n m.+1)). Proof. by []. Qed.
Lemma CS0 n : C n.+1 0 = (1, 0). Proof. by []. Qed.
Lemma C0S m : C 0 m.+1 = (0, 0). Proof. by []. Qed.

Lemma vw n m : v n m = ds (1, 0) (w n m).
Proof.
have e := den_neq0 n m; congr (_, _); rewrite /= ?sub0r //.
by move: e; rewrite /den => e; field.
Qed.

(* the chance to visit a state is a difference of two cumulative ones *)
Theorem G_C n m : G n m = ds (C n.+1 m) (C n m.+1).
Proof.
have dsz (f : dual) : ds f (0, 0) = f by case: f => x y; rewrite /ds /= !subr0.
have [k] := ubnP (n + m)%N; elim: k n m => // k IH [|n] [|m]; rewrite ltnS => le.
- by rewrite CS0 C0S dsz.
- rewrite G0S /F IH ?add0n // !C0S dsz CSS C0S dsz.
  by congr (_, _); rewrite /= !mulr0 !addr0.
- rewrite GS0 /H IH ?addn0 //; last by move: le; rewrite addn0.
  rewrite !CS0 vw [C n.+1 1]CSS CS0 vw; congr (_, _); rewrite /=; ring.
- rewrite GSS /F /H !IH ?(leq_trans _ le) ?addSn ?addnS //.
  rewrite [C n.+2 m.+1]CSS [C n.+1 m.+2]CSS !vw.
  by congr (_, _); rewrite /=; ring.
Qed.

Lemma w2_ge0 n m : 0 <= (w n m).2.
Proof.
by rewrite /w /= divr_ge0 ?exprn_ge0 ?(ltW (den_gt0 _ _)) // mulr_ge0 ?(ltW r_gt0) // addr_ge0 // ltW.
Qed.

Lemma C_decr n m : 0 < (C n.+1 m).1 - (C n m.+1).1.
Proof. by have := G1_gt0 n m; rewrite G_C. Qed.

(* the cumulative functions do not fall *)
Theorem C_mono n m : 0 <= (C n m).2.
Proof.
elim: n m => [|n IHn]; first by case=> [|m]; rewrite ?C0S /= ?lexx.
elim=> [|m IHm]; first by rewrite CS0 /= lexx.
rewrite CSS; set c := C n.+1 m in IHm *; set c' := C n m.+1.
have d := C_decr n m; rewrite -/c -/c' in d.
have -> : (da (dm (w n m) c) (dm (v n m) c')).2 =
  (w n m).2 * (c.1 - c'.1) + (w n m).1 * c.2 + (v n m).1 * c'.2.
  by rewrite /da /dm /w /v /=; ring.
by rewrite !addr_ge0 // mulr_ge0 // ?w2_ge0 ?(ltW d) // IHn.
Qed.

End Race.
