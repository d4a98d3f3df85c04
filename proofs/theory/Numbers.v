(* Values of the definitions at rational numbers, computed: in the binary fractions of Coq's QArith, of which `frac` is the number
   in any ordered field. Each evaluator below is proved to be its definition, with 1/0 = 0 on both sides; so the numbers of
   Examples.v, which the program prints, are numbers of the paper's functions. *)
From Coq Require Import ZArith QArith Qreduction.
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify ssrZ.
From Bsplines Require Import Definitions Pieces Derivatives Values Terms.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- the evaluators: after each operation a fraction is reduced ---- *)
Definition addq x y := Qred (Qplus x y).
Definition oppq x := Qred (Qopp x).
Definition mulq x y := Qred (Qmult x y).
Definition invq x := Qred (Qinv x).
Definition zeroq : Q := Qmake Z0 xH.
Definition oneq : Q := Qmake (Zpos xH) xH.
Definition subq x y := addq x (oppq y).
Definition divq x y := mulq x (invq y).
Definition leq_ x y := Qle_bool x y.
Definition ltq x y := ~~ Qle_bool y x.

Section Evaluators.
Variables (r : Q) (t : nat -> Q).
Definition mobq x a b := divq (mulq r (subq x a)) (addq (mulq r (subq x a)) (subq b x)).
Definition dmobq x a b :=
  let d := addq (mulq r (subq x a)) (subq b x) in divq (mulq r (subq b a)) (mulq d d).
Definition wtq d i x := if leq_ (t i) x && ltq x (t (i + d)%N) then mobq x (t i) (t (i + d)%N) else zeroq.
Fixpoint Gq k i x : Q :=
  if k is d.+1 then addq (mulq (wtq d.+1 i x) (Gq d i x)) (mulq (subq oneq (wtq d.+1 i.+1 x)) (Gq d i.+1 x))
  else if leq_ (t i) x && ltq x (t i.+1) then oneq else zeroq.
Fixpoint Nq s k i x : Q :=
  if k is d.+1 then addq (mulq (mobq x (t i) (t (i + d.+1)%N)) (Nq s d i x))
                         (mulq (subq oneq (mobq x (t i.+1) (t (i.+1 + d.+1)%N))) (Nq s d i.+1 x))
  else if i == s then oneq else zeroq.
Fixpoint dNq s k i x : Q :=
  if k is d.+1 then
    addq (addq (mulq (dmobq x (t i) (t (i + d.+1)%N)) (Nq s d i x)) (mulq (mobq x (t i) (t (i + d.+1)%N)) (dNq s d i x)))
         (addq (mulq (oppq (dmobq x (t i.+1) (t (i.+1 + d.+1)%N))) (Nq s d i.+1 x))
               (mulq (subq oneq (mobq x (t i.+1) (t (i.+1 + d.+1)%N))) (dNq s d i.+1 x)))
  else zeroq.
Fixpoint last_spanq m : nat := if m is p.+1 then if ltq (t p) (t p.+1) then p else last_spanq p else 0.
Fixpoint right_spanq m x : nat := if m is p.+1 then if leq_ (t p) x then p else right_spanq p x else 0.
Fixpoint left_spanq m x : nat := if m is p.+1 then if ltq (t p) x then p else left_spanq p x else 0.
Definition valueq m k i x :=
  if ltq x (t m) then Gq k i x
  else if leq_ x (t m) && leq_ (t m) x then Nq (last_spanq m) k i x else zeroq.
Definition Gleftq m k i x := if ltq (t 0%N) x && leq_ x (t m) then Nq (left_spanq m x) k i x else zeroq.
Definition DGleftq m k i x := if ltq (t 0%N) x && leq_ x (t m) then dNq (left_spanq m x) k i x else zeroq.
Definition DGrightq m k i x := if leq_ (t 0%N) x && ltq x (t m) then dNq (right_spanq m x) k i x else zeroq.
End Evaluators.

(* ---- a fraction as a number ---- *)
Section Numbers.
Variable R : realFieldType.
Definition whole (n : Z) : R := (int_of_Z n)%:~R.
Definition frac (x : Q) : R := whole (Qnum x) / whole (Zpos (Qden x)).

Lemma wholeD a b : whole (a + b)%Z = whole a + whole b.
Proof. by rewrite /whole -intrD; congr (_%:~R); lia. Qed.
Lemma wholeM a b : whole (a * b)%Z = whole a * whole b.
Proof. by rewrite /whole -intrM; congr (_%:~R); lia. Qed.
Lemma wholeN a : whole (- a)%Z = - whole a.
Proof. by rewrite /whole -mulrNz; congr (_%:~R); lia. Qed.
Lemma whole_le a b : (whole a <= whole b) = Z.leb a b.
Proof. by rewrite /whole ler_int; lia. Qed.
Lemma whole_pos p : 0 < whole (Zpos p).
Proof. by rewrite /whole ltr0z; lia. Qed.
Lemma whole_neq0 p : whole (Zpos p) != 0.
Proof. by rewrite gt_eqF // whole_pos. Qed.
Hint Resolve whole_neq0 : core.

Lemma frac_eq x y : Qeq x y -> frac x = frac y.
Proof.
case: x y => [a b] [c d]; rewrite /Qeq /frac /= => e; have := congr1 whole e; rewrite !wholeM => h.
have n1 := whole_neq0 b; have n2 := whole_neq0 d.
by apply: (mulIf n1); apply: (mulIf n2); rewrite divfK // h mulrAC divfK.
Qed.
Lemma frac_red x : frac (Qred x) = frac x. Proof. by apply: frac_eq; apply: Qred_correct. Qed.
Lemma whole0 : whole Z0 = 0. Proof. by []. Qed.
Lemma frac0 : frac zeroq = 0. Proof. by rewrite /frac -[Qnum zeroq]/Z0 whole0 mul0r. Qed.
Lemma frac1 : frac oneq = 1. Proof. exact: (divff (whole_neq0 xH)). Qed.
Lemma fracD x y : frac (addq x y) = frac x + frac y.
Proof.
rewrite frac_red; case: x y => [a b] [c d]; rewrite /frac /= Pos2Z.inj_mul wholeD !wholeM.
by have n1 := whole_neq0 b; have n2 := whole_neq0 d; field; rewrite n1 n2.
Qed.
Lemma fracN x : frac (oppq x) = - frac x.
Proof. by rewrite frac_red; case: x => [a b]; rewrite /frac /= wholeN mulNr. Qed.
Lemma fracM x y : frac (mulq x y) = frac x * frac y.
Proof.
rewrite frac_red; case: x y => [a b] [c d]; rewrite /frac /= Pos2Z.inj_mul !wholeM.
by have n1 := whole_neq0 b; have n2 := whole_neq0 d; field; rewrite n1 n2.
Qed.
Lemma fracV x : frac (invq x) = (frac x)^-1.
Proof.
rewrite frac_red; case: x => [[|a|a] b]; rewrite /frac /Qinv /=; first by rewrite whole0 !mul0r invr0.
- by rewrite invf_div.
- by rewrite -[Z.neg b]/(- Z.pos b)%Z -[Z.neg a]/(- Z.pos a)%Z !wholeN invf_div mulNr invrN mulrN.
Qed.
Lemma fracB x y : frac (subq x y) = frac x - frac y. Proof. by rewrite fracD fracN. Qed.
Lemma frac_div x y : frac (divq x y) = frac x / frac y. Proof. by rewrite fracM fracV. Qed.
Lemma frac_le x y : (frac x <= frac y) = leq_ x y.
Proof.
case: x y => [a b] [c d]; rewrite /frac /leq_ /Qle_bool /= -whole_le !wholeM.
by rewrite ler_pdivr_mulr ?whole_pos // mulrAC ler_pdivl_mulr ?whole_pos.
Qed.
Lemma frac_lt x y : (frac x < frac y) = ltq x y. Proof. by rewrite ltNge frac_le. Qed.
Lemma frac_eqE x y : (frac x == frac y) = leq_ x y && leq_ y x. Proof. by rewrite eq_le !frac_le. Qed.

(* ---- each evaluator is its definition ---- *)
Variables (r : Q) (t : nat -> Q).
Local Notation T := (fun i => frac (t i)).
Definition fracE := (fracD, fracM, fracB, fracN, frac_div, frac0, frac1).

Lemma mobqE x a b : mob (frac r) (frac x) (frac a) (frac b) = frac (mobq r x a b).
Proof. by rewrite /mob /mobq !fracE. Qed.
Lemma dmobqE x a b : dmob (frac r) (frac x) (frac a) (frac b) = frac (dmobq r x a b).
Proof. by rewrite /dmob /dmobq !fracE expr2. Qed.
Theorem wtqE d i x : wt (frac r) T d i (frac x) = frac (wtq r t d i x).
Proof. by rewrite /wt /phi /wtq frac_le frac_lt mobqE; case: ifP; rewrite ?frac0. Qed.
Theorem GqE k i x : G (wt (frac r) T) T k i (frac x) = frac (Gq r t k i x).
Proof.
elim: k i => [|k IH] i /=; first by rewrite frac_le frac_lt; case: ifP; rewrite ?fracE.
by rewrite !wtqE !IH !fracE.
Qed.
Lemma NqE s k i x : P (frac r) T s k i (frac x) = frac (Nq r t s k i x).
Proof.
rewrite /P /piece; elim: k i => [|k IH] i /=; first by case: eqP; rewrite ?fracE.
by rewrite !IH /mw !mobqE !fracE.
Qed.
Lemma dNqE s k i x : dP (frac r) T s k i (frac x) = frac (dNq r t s k i x).
Proof.
rewrite /dP; elim: k i => [|k IH] i /=; first by rewrite frac0.
by rewrite !IH -![N _ _ _ _]/(P (frac r) T s k _ (frac x)) !NqE /mw /dmw !mobqE !dmobqE !fracE.
Qed.
Lemma last_spanqE m : last_span T m = last_spanq t m.
Proof. by elim: m => //= m ->; rewrite frac_lt. Qed.
Lemma right_spanqE m x : right_span T m (frac x) = right_spanq t m x.
Proof. by elim: m => //= m ->; rewrite frac_le. Qed.
Lemma left_spanqE m x : left_span T m (frac x) = left_spanq t m x.
Proof. by elim: m => //= m ->; rewrite frac_lt. Qed.
Theorem valueqE m k i x : value (frac r) T m k i (frac x) = frac (valueq r t m k i x).
Proof.
rewrite /value /valueq frac_lt frac_eqE GqE last_spanqE NqE.
by case: ifP => // _; case: ifP; rewrite ?frac0.
Qed.
Theorem GleftqE m k i x : Gleft (frac r) T m k i (frac x) = frac (Gleftq r t m k i x).
Proof. by rewrite /Gleft /limit_left /Gleftq frac_lt frac_le left_spanqE NqE; case: ifP; rewrite ?frac0. Qed.
Theorem DGleftqE m k i x : DGleft (frac r) T m k i (frac x) = frac (DGleftq r t m k i x).
Proof. by rewrite /DGleft /Dleft /DGleftq frac_lt frac_le left_spanqE dNqE; case: ifP; rewrite ?frac0. Qed.
Theorem DGrightqE m k i x : DGright (frac r) T m k i (frac x) = frac (DGrightq r t m k i x).
Proof. by rewrite /DGright /Dright /DGrightq frac_lt frac_le right_spanqE dNqE; case: ifP; rewrite ?frac0. Qed.
End Numbers.

(* an equation of a number, by computing both sides *)
Ltac computed E := rewrite E; apply: congr1; vm_compute; reflexivity.
