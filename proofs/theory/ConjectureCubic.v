(* Conj3.1 fails for k = 3: exact rational witness, computed in Q by vm_compute, carried to every realFieldType.
   alpha = 2 (r = 2), knots 0, 2, 3, 5, 10 (all simple): G_0^3 is lower at 3 than at 299/100 and at 3001/1000. *)
From Coq Require Import ZArith QArith Qreduction List.
Import ListNotations.
Module BQ.
Open Scope Q_scope.
Definition Qltb (a b : Q) : bool := negb (Qle_bool b a).
Section S.
Variable (r : Q) (t : nat -> Q).
Definition phi (x a b : Q) : Q :=
  if andb (Qle_bool a x) (Qltb x b) then Qred (r * (x - a) / (r * (x - a) + (b - x))) else 0.
Fixpoint G (k i : nat) (x : Q) : Q :=
  match k with
  | O => if andb (Qle_bool (t i) x) (Qltb x (t (S i))) then 1 else 0
  | S k' => Qred (phi x (t i) (t (i + S k')) * G k' i x
                  + (1 - phi x (t (S i)) (t (i + S (S k')))) * G k' (S i) x)
  end.
End S.
Definition kn (i : nat) : Q := nth i [0; 2; 3; 5; 10] 10.
Definition g := G 2 kn 3 0.
Definition x1 : Q := 299#100.
Definition x2 : Q := 3.
Definition x3 : Q := 3001#1000.
Definition q0 : Q := 0. Definition q1 : Q := 1. Definition q2 : Q := 2.
Close Scope Q_scope.
End BQ.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import zify ssrZ ring.
From Bsplines Require Import Definitions.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Bridge.
Variable R : realFieldType.
Definition z2r (z : Z) : R := (int_of_Z z)%:~R.
Definition q2r (q : Q) : R := z2r (Qnum q) / z2r (Zpos (Qden q)).

Lemma z2rD a b : z2r (Z.add a b) = z2r a + z2r b.
Proof. by rewrite /z2r -rmorphD -rmorphD. Qed.
Lemma z2rM a b : z2r (Z.mul a b) = z2r a * z2r b.
Proof. by rewrite /z2r -rmorphM -rmorphM. Qed.
Lemma z2rN a : z2r (Z.opp a) = - z2r a.
Proof. by rewrite /z2r -rmorphN -rmorphN. Qed.
Lemma z2r_le a b : (z2r a <= z2r b) = (Z.leb a b).
Proof. rewrite /z2r ler_int; apply/idP/idP; lia. Qed.
Lemma z2r_lt a b : (z2r a < z2r b) = (Z.ltb a b).
Proof. rewrite /z2r ltr_int; apply/idP/idP; lia. Qed.
Lemma z2r_pos p : 0 < z2r (Zpos p).
Proof. by rewrite -[0]/(z2r Z0) z2r_lt. Qed.
Lemma z2r_pos0 p : z2r (Zpos p) != 0. Proof. exact: lt0r_neq0 (z2r_pos p). Qed.

Lemma q2rD a b : q2r (Qplus a b) = q2r a + q2r b.
Proof.
rewrite /q2r /= z2rD !z2rM Pos2Z.inj_mul z2rM.
by field; rewrite !z2r_pos0.
Qed.
Lemma q2rM a b : q2r (Qmult a b) = q2r a * q2r b.
Proof.
rewrite /q2r /= z2rM Pos2Z.inj_mul z2rM.
by field; rewrite !z2r_pos0.
Qed.
Lemma q2rN a : q2r (Qopp a) = - q2r a.
Proof. by rewrite /q2r /= z2rN mulNr. Qed.
Lemma q2rB a b : q2r (Qminus a b) = q2r a - q2r b.
Proof. by rewrite /Qminus q2rD q2rN. Qed.
Lemma q2rV a : q2r (Qinv a) = (q2r a)^-1.
Proof.
case: a => [[|p|p] d]; rewrite /q2r /Qinv /=.
- by rewrite !mul0r invr0.
- by rewrite invf_div.
rewrite -!Pos2Z.opp_pos !z2rN; field; rewrite ?oppr_eq0 !z2r_pos0 //.
Qed.
Lemma q2r_div a b : q2r (Qdiv a b) = q2r a / q2r b.
Proof. by rewrite /Qdiv q2rM q2rV. Qed.
Lemma q2r_eq a b : Qeq a b -> q2r a = q2r b.
Proof.
rewrite /Qeq /q2r => H; apply/eqP; rewrite eqr_div ?z2r_pos0 //.
by rewrite -!z2rM H.
Qed.
Lemma q2r_red a : q2r (Qred a) = q2r a. Proof. exact: q2r_eq (Qred_correct a). Qed.
Lemma q2r_le a b : (q2r a <= q2r b) = Qle_bool a b.
Proof.
rewrite /q2r /Qle_bool ler_pdivr_mulr ?z2r_pos // mulrAC ler_pdivl_mulr ?z2r_pos //.
by rewrite -!z2rM z2r_le.
Qed.
Lemma q2r_lt a b : (q2r a < q2r b) = BQ.Qltb a b.
Proof. by rewrite ltNge q2r_le. Qed.
Lemma q2r0 : q2r BQ.q0 = 0. Proof. by rewrite /q2r mul0r. Qed.
Lemma q2r1 : q2r BQ.q1 = 1. Proof. by rewrite /q2r divr1. Qed.

Variables (r : Q) (t : nat -> Q).
Arguments Qred : simpl never. Arguments Qplus : simpl never.
Arguments Qmult : simpl never. Arguments Qminus : simpl never.
Lemma phi_q2r x a b : Definitions.phi (q2r r) (q2r x) (q2r a) (q2r b) = q2r (BQ.phi r x a b).
Proof.
rewrite /Definitions.phi /mob /BQ.phi q2r_le q2r_lt.
case: (_ && _); last by rewrite -q2r0.
by rewrite q2r_red q2r_div q2rD q2rM !q2rB.
Qed.
Lemma G_q2r k i x : let t' := fun n => q2r (t n) in
  Definitions.G (wt (q2r r) t') t' k i (q2r x) = q2r (BQ.G r t k i x).
Proof.
move=> t'; elim: k i => [|k IH] i; first by rewrite /= /t' q2r_le q2r_lt; case: (_ && _); rewrite -?q2r0 -?q2r1.
rewrite GS !IH /wt /t' !phi_q2r addSnnS [BQ.G _ _ _ _ _]/=.
by rewrite q2r_red q2rD !q2rM q2rB -q2r1.
Qed.
End Bridge.

Definition kn (R : realFieldType) (n : nat) : R := q2r R (BQ.kn n).
(* Conj3.1.strong.continuous: r = 2, knots 0, 2, 3, 5, 10: G_0 is lower at 3 than at two points on both sides *)
Theorem Conj3_1_false_k3 (R : realFieldType) : exists x1 x2 x3 : R, [/\ kn R 0 < x1, x1 < x2, x2 < x3, x3 < kn R 4 &
    let g := Definitions.G (wt (q2r R BQ.q2) (kn R)) (kn R) 3 0 in
    g x2 < g x1 /\ g x2 < g x3].
Proof.
exists (q2r R BQ.x1), (q2r R BQ.x2), (q2r R BQ.x3).
have H (a b : Q) : BQ.Qltb a b = true -> q2r R a < q2r R b by move=> e; rewrite q2r_lt e.
split; try (rewrite /kn; apply: H; by vm_compute).
by cbv zeta; rewrite !G_q2r; split; apply: H; vm_compute.
Qed.
(* the knots of the example are simple *)
Theorem kn_simple (R : realFieldType) : [/\ kn R 0 < kn R 1, kn R 1 < kn R 2, kn R 2 < kn R 3 & kn R 3 < kn R 4].
Proof.
have H (a b : Q) : BQ.Qltb a b = true -> q2r R a < q2r R b by move=> e; rewrite q2r_lt e.
by split; rewrite /kn; apply: H; vm_compute.
Qed.
(* r = 2 is alpha = 2 *)
Lemma q2_is_alpha2 (R : realFieldType) : q2r R BQ.q2 = 2%:R / (2%:R - 1).
Proof.
have -> : q2r R BQ.q2 = 2%:R by rewrite /q2r /z2r /= divr1.
by have -> : (2%:R : R) - 1 = 1 by [ring]; rewrite divr1.
Qed.
