(* Glue: the tower of Tower.v for the concrete C of recursion (1) satisfies every hypothesis of CoreInequality.v. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower CoreInequality.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Perm.
Variable R : realFieldType.
Notation pos := (all (>%R^~ (0 : R))).
Lemma swapl p q A B : 0 < p -> 0 < q -> pos B -> cl (p :: q :: A) B = cl (q :: p :: A) B :> R.
Proof.
move=> p0 q0 hB; case: (eqVneq p q) => [-> //|n].
have d : p - q != 0 by rewrite subr_eq0.
apply: (mulfI d); rewrite leftrel //.
have -> : (p - q) * cl (q :: p :: A) B = - ((q - p) * cl (q :: p :: A) B) by ring.
by rewrite leftrel //; ring.
Qed.
Lemma swapr p q A B : 0 < p -> 0 < q -> pos A -> cl A (p :: q :: B) = cl A (q :: p :: B) :> R.
Proof.
move=> p0 q0 hA; case: (eqVneq p q) => [-> //|n].
have d : q - p != 0 by rewrite subr_eq0 eq_sym.
apply: (mulfI d); rewrite rightrel //.
have -> : (q - p) * cl A (q :: p :: B) = - ((p - q) * cl A (q :: p :: B)) by ring.
by rewrite rightrel //; ring.
Qed.

Lemma perm_split (s t : seq R) a a' : perm_eq (a :: s) (a' :: t) -> a != a' ->
  exists r, perm_eq s (a' :: r) /\ perm_eq t (a :: r).
Proof.
move=> p n.
have ms : a' \in s by have := mem_head a' t; rewrite -(perm_mem p) inE eq_sym (negbTE n).
exists (rem a' s); have ps := perm_to_rem ms; split=> //.
rewrite -(perm_cons a') perm_sym (perm_trans _ p) //.
by rewrite (perm_trans (_ : perm_eq _ (a :: a' :: rem a' s))) ?(perm_catCA [:: a'] [:: a]) // perm_cons perm_sym.
Qed.

(* restricted versions: the other list positive *)
Lemma clconsl (a : R) s s' B : (forall B, pos B -> cl s B = cl s' B) -> pos B -> cl (a :: s) B = cl (a :: s') B.
Proof.
move=> h; elim: B => [|b B IH] // hB; have /andP[b0 hB'] := hB.
by rewrite !clE IH // h.
Qed.
Lemma clconsr (b : R) s s' A : (forall A : seq R, pos A -> cl A s = cl A s') -> pos A -> cl A (b :: s) = cl A (b :: s').
Proof.
move=> h; elim: A => [|a A IH] // hA; have /andP[a0 hA'] := hA.
by rewrite !clE IH // h.
Qed.

Lemma cl_perml (s t : seq R) : perm_eq s t -> pos s -> forall B, pos B -> cl s B = cl t B.
Proof.
have [n] := ubnP (size s); elim: n s t => // n IH [|a s] [|a' t] zn p hs B hB //.
- by have := perm_size p.
- by have := perm_size p.
have /andP[a0 hs'] := hs; rewrite ltnS in zn.
have ht : pos (a' :: t) by rewrite -(perm_all _ p).
have /andP[a0' ht'] := ht.
case: (eqVneq a a') p => [<-|ne] p.
  by apply: clconsl => // B' hB'; apply: IH => //; rewrite -(perm_cons a).
have [r [ps pt]] := perm_split p ne.
have zt : size t = size s by have := perm_size p => -[].
rewrite (@clconsl a s (a' :: r) B) //; last by move=> B' hB'; apply: IH.
rewrite (@clconsl a' t (a :: r) B) //; last by move=> B' hB'; apply: IH => //; rewrite /= zt.
exact: swapl.
Qed.
Lemma cl_permr (s t : seq R) : perm_eq s t -> pos s -> forall A, pos A -> cl A s = cl A t.
Proof.
have [n] := ubnP (size s); elim: n s t => // n IH [|a s] [|a' t] zn p hs B hB //.
- by have := perm_size p.
- by have := perm_size p.
have /andP[a0 hs'] := hs; rewrite ltnS in zn.
have ht : pos (a' :: t) by rewrite -(perm_all _ p).
have /andP[a0' ht'] := ht.
case: (eqVneq a a') p => [<-|ne] p.
  by apply: clconsr => // B' hB'; apply: IH => //; rewrite -(perm_cons a).
have [r [ps pt]] := perm_split p ne.
have zt : size t = size s by have := perm_size p => -[].
rewrite (@clconsr a s (a' :: r) B) //; last by move=> B' hB'; apply: IH.
rewrite (@clconsr a' t (a :: r) B) //; last by move=> B' hB'; apply: IH => //; rewrite /= zt.
exact: swapr.
Qed.
End Perm.

Section Glue.
Variable R : realFieldType.
Variable I : eqType.
Variable y : I -> R.
Hypothesis y_side : forall l, lft y l || rgt y l.
Definition Ls s := [seq - y l | l <- s & lft y l].
Definition Rs s := [seq y l | l <- s & rgt y l].
Definition C s := cl (Ls s) (Rs s).
Lemma Ls_l l s : lft y l -> Ls (l :: s) = - y l :: Ls s. Proof. by move=> h; rewrite /Ls /= h. Qed.
Lemma Rs_l l s : lft y l -> Rs (l :: s) = Rs s. Proof. by move=> h; rewrite /Rs /= (lft_rgtF h). Qed.
Lemma Ls_r l s : rgt y l -> Ls (l :: s) = Ls s. Proof. by move=> h; rewrite /Ls /= (rgt_lftF h). Qed.
Lemma Rs_r l s : rgt y l -> Rs (l :: s) = y l :: Rs s. Proof. by move=> h; rewrite /Rs /= h. Qed.
Lemma Lpos s : all (>%R^~ 0) (Ls s).
Proof. by apply/allP => x /mapP[l]; rewrite mem_filter => /andP[h _] ->; rewrite /= oppr_gt0. Qed.
Lemma Rpos s : all (>%R^~ 0) (Rs s).
Proof. by apply/allP => x /mapP[l]; rewrite mem_filter => /andP[h _] ->. Qed.

Lemma Cperm s t : perm_eq s t -> C s = C t.
Proof.
move=> p; rewrite /C (@cl_perml R _ (Ls t)) ?Lpos ?Rpos //; last by rewrite perm_map // perm_filter.
by apply: cl_permr; rewrite ?Lpos ?Rpos // perm_map // perm_filter.
Qed.

Lemma Crel s l m : (y m - y l) * C (l :: m :: s) = y m * C (m :: s) - y l * C (l :: s).
Proof.
have lr (a b : I) : lft y a -> rgt y b -> (y b - y a) * C (a :: b :: s) = y b * C (b :: s) - y a * C (a :: s).
  move=> ha hb; rewrite /C !(Ls_l _ ha) !(Rs_l _ ha) !(Ls_r _ hb) !(Rs_r _ hb).
  have := clE (- y a) (Ls s) (y b) (Rs s).
  have d : - y a + y b != 0 by rewrite gt_eqF // addr_gt0 // oppr_gt0.
  move: (cl (- y a :: Ls s) (y b :: Rs s)) (cl (- y a :: Ls s) (Rs s)) (cl (Ls s) (y b :: Rs s)) => X u v ->.
  by field.
case/orP: (y_side l) => hl; case/orP: (y_side m) => hm.
- rewrite /C !(Ls_l _ hl) !(Rs_l _ hl) !(Ls_l _ hm) !(Rs_l _ hm).
  have e : forall u v w, (- y l - - y m) * u = - y l * v - - y m * w -> (y m - y l) * u = y m * w - y l * v.
    move=> u v w h; have -> : y m - y l = - y l - - y m by ring.
    by rewrite h; ring.
  by apply: e; apply: leftrel; rewrite ?Rpos // oppr_gt0.
- exact: lr.
- have -> : C (l :: m :: s) = C (m :: l :: s) by apply: Cperm; rewrite (perm_catCA [:: l] [:: m]).
  have -> : (y m - y l) * C (m :: l :: s) = - ((y l - y m) * C (m :: l :: s)) by ring.
  by rewrite lr //; ring.
- rewrite /C !(Ls_r _ hl) !(Rs_r _ hl) !(Ls_r _ hm) !(Rs_r _ hm).
  by apply: rightrel; rewrite ?Lpos.
Qed.

Lemma yn0 l : y l != 0. Proof. exact: (y_neq0 y_side). Qed.
Notation DD := (Tower.D y C).
Lemma DDperm j s t : perm_eq s t -> DD j s = DD j t.
Proof. by case: (Drel_perm yn0 Cperm Crel j) => _; apply. Qed.
Lemma DDrel j s l m : (j <= size s)%N ->
  (y m - y l) * DD j (l :: m :: s) = y m * DD j (m :: s) - y l * DD j (l :: s).
Proof. by case: (Drel_perm yn0 Cperm Crel j) => h _; apply: h. Qed.
Lemma DDtower j s l : (j < size s)%N -> DD j s = DD j (l :: s) + y l * DD j.+1 (l :: s).
Proof. by move=> h; apply: (Tower.tower yn0). Qed.

Lemma noL s : ~~ has (lft y) s -> C s = 0.
Proof. by rewrite has_filter negbK /C /Ls => /eqP ->. Qed.
Lemma noR s : ~~ has (rgt y) s -> (0 < size s)%N -> C s = 1.
Proof.
move=> h; have e : Rs s = [::] by move: h; rewrite has_filter negbK /Rs => /eqP ->.
case: s h e => [//|l s] h e _.
have hl : lft y l by case/orP: (y_side l) => // hr; rewrite /= hr in h.
by rewrite /C e (Ls_l _ hl) clA0.
Qed.

Lemma DDone s : (2 <= size s)%N -> ~~ two y s -> DD 1 s = 0.
Proof.
case: s => [//|l s] zs; rewrite /two negb_and => h.
rewrite DE //; case/orP: h => h.
  have h' : ~~ has (lft y) s by apply: contra h => /= ->; rewrite orbT.
  by rewrite /= !noL // subrr mul0r.
have h' : ~~ has (rgt y) s by apply: contra h => /= ->; rewrite orbT.
by rewrite /= !noR // subrr mul0r.
Qed.

Lemma DDpos s : two y s -> 0 < DD 1 s.
Proof.
have [n] := ubnP (size s); elim: n s => // n IH s zn t.
have [l [s1 [hl p /hasP[r rs hr]]]] := pick_l t.
pose s2 := rem r s1.
have p2 : perm_eq s (l :: r :: s2) by rewrite (perm_trans p) // perm_cons perm_to_rem.
have zs : size s = (size s2).+2 by rewrite (perm_size p2).
rewrite (DDperm 1 p2).
have d : 0 < y r - y l by rewrite subr_gt0 (lt_trans hl hr).
case: s2 p2 zs => [|e s2] p2 zs.
  have c1 : C [:: r] = 0 by apply: noL; rewrite /= (rgt_lftF hr).
  have c2 : C [:: l] = 1 by apply: noR; rewrite //= (lft_rgtF hl).
  have := Crel [::] l r; rewrite c1 c2 mulr0 sub0r mulr1 => h.
  rewrite DE // /= c1 sub0r -(pmulr_rgt0 _ d) mulrA mulrN h opprK divff ?ltr01 //; exact: yn0.
rewrite -(pmulr_rgt0 _ d) DDrel //.
have ge s' : (size s' < size s)%N -> (2 <= size s')%N -> 0 <= DD 1 s'.
  move=> h1 h2; case: (boolP (two y s')) => h; last by rewrite DDone.
  by rewrite ltW // IH // (leq_trans h1) // -ltnS.
have k1 : 0 <= DD 1 (r :: e :: s2) by apply: ge; rewrite ?zs.
have k2 : 0 <= DD 1 (l :: e :: s2) by apply: ge; rewrite ?zs.
have sz (x : I) : (size (x :: e :: s2) < n)%N by rewrite -ltnS (leq_trans _ zn) // zs.
case/orP: (y_side e) => he.
  apply: ltr_paddr; first by rewrite oppr_ge0 mulr_le0_ge0 // ltW.
  by rewrite mulr_gt0 // IH // /two /= he hr !orbT.
rewrite addrC; apply: ltr_paddr; first by rewrite mulr_ge0 // ltW.
by rewrite -mulNr mulr_gt0 ?oppr_gt0 // IH // /two /= hl he !orbT.
Qed.

(* Theorem A for the concrete C of recursion (1) *)
Theorem theoremA_concrete (V : seq I) (t0 : I) (c : I -> R) :
  uniq V -> two y V -> (forall l, 0 <= c l) -> 0 < y t0 ->
  let A0 := \sum_(q <- V) c q * DD 1 (q :: V) in
  let A0' := \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * DD 2 (l :: m :: V) in
  let A1 := \sum_(q <- V) c q * DD 1 (q :: t0 :: V) in
  let A1' := \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * DD 2 (l :: m :: t0 :: V) in
  0 <= A0 * A1' - A0' * A1.
Proof.
move=> uV tV c0 b0.
exact: (theoremA y_side DDperm DDtower DDpos DDone uV tV c0 b0).
Qed.
End Glue.
