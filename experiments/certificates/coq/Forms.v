(** Forms in s = 1 - t and t: what the entries of a moving pose are. *)
Require Import List ZArith QArith Lia Lqa.
Import ListNotations.
Open Scope Z_scope.

(** The coefficients of s^n, s^(n-1) t, ..., t^n. *)
Definition form := list Z.

Fixpoint power (s : Q) (n : nat) : Q := match n with O => 1%Q | S n => (s * power s n)%Q end.

Fixpoint value (f : form) (s t : Q) : Q :=
  match f with
  | [] => 0%Q
  | c :: g => (inject_Z c * power s (length g) + t * value g s t)%Q
  end.

(** ** Sums and products *)

Fixpoint fadd (f g : form) : form :=
  match f, g with
  | [], _ => g
  | _, [] => f
  | x :: f, y :: g => x + y :: fadd f g
  end.

Definition fscale (k : Z) : form -> form := map (Z.mul k).

(** The product with x s + y t. *)
Definition linear (x y : Z) (f : form) : form := fadd (fscale x f ++ [0]) (0 :: fscale y f).

Fixpoint fmul (f g : form) : form :=
  match f with
  | [] => []
  | [c] => fscale c g
  | c :: f => fadd (fscale c g ++ repeat 0 (length f)) (0 :: fmul f g)
  end.

Lemma fadd_length f : forall g, length f = length g -> length (fadd f g) = length f.
Proof. induction f as [|x f IH]; intros [|y g]; simpl; intros E; try lia. injection E as E. rewrite IH; auto. Qed.

Lemma fscale_length k f : length (fscale k f) = length f.
Proof. apply map_length. Qed.

Lemma linear_length x y f : length (linear x y f) = S (length f).
Proof. unfold linear. rewrite fadd_length; [|simpl]; rewrite app_length, fscale_length; [simpl; lia|]. rewrite fscale_length. simpl. lia. Qed.

Lemma fmul_length f g : f <> [] -> g <> [] -> S (length (fmul f g)) = (length f + length g)%nat.
Proof.
  intros some_f some_g. assert (G : (0 < length g)%nat) by (destruct g; [contradiction | simpl; lia]).
  induction f as [|c f IH]; [contradiction|]. destruct f as [|d f]; [simpl; rewrite fscale_length; lia|].
  assert (E : S (length (fmul (d :: f) g)) = (length (d :: f) + length g)%nat) by (apply IH; discriminate).
  change (fmul (c :: d :: f) g) with (fadd (fscale c g ++ repeat 0 (length (d :: f))) (0 :: fmul (d :: f) g)).
  assert (L : length (fscale c g ++ repeat 0 (length (d :: f))) = (length g + length (d :: f))%nat)
    by (rewrite app_length, fscale_length, repeat_length; reflexivity).
  rewrite fadd_length; rewrite L; simpl length in *; lia.
Qed.

Open Scope Q_scope.

Lemma value_fadd s t f : forall g, length f = length g -> value (fadd f g) s t == value f s t + value g s t.
Proof.
  induction f as [|x f IH]; intros [|y g]; simpl; intros E; try discriminate; [ring|]. injection E as E.
  rewrite IH by assumption. rewrite fadd_length by assumption. rewrite <- E, inject_Z_plus. ring.
Qed.

Lemma value_fscale k f s t : value (fscale k f) s t == inject_Z k * value f s t.
Proof. induction f as [|x f IH]; simpl; [ring|]. fold (fscale k f). rewrite IH, fscale_length, inject_Z_mult. ring. Qed.

Lemma value_zeros s t n : value (repeat 0%Z n) s t == 0.
Proof. induction n as [|n IH]; simpl; [reflexivity|]. rewrite IH. unfold inject_Z. ring. Qed.

Lemma power_plus s m n : power s (m + n) == power s m * power s n.
Proof. induction m as [|m IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma value_shifted f s t n : value (f ++ repeat 0%Z n) s t == power s n * value f s t.
Proof.
  induction f as [|x f IH]; simpl; [rewrite value_zeros; ring|].
  rewrite IH, app_length, repeat_length, power_plus. ring.
Qed.

Lemma value_linear x y f s t : value (linear x y f) s t == (inject_Z x * s + inject_Z y * t) * value f s t.
Proof.
  unfold linear. rewrite value_fadd by (simpl; rewrite app_length, !fscale_length; simpl; lia).
  change [0%Z] with (repeat 0%Z 1). rewrite value_shifted. simpl. rewrite !value_fscale, fscale_length. unfold inject_Z at 2. ring.
Qed.

Lemma value_fmul f g s t : f <> [] -> g <> [] -> value (fmul f g) s t == value f s t * value g s t.
Proof.
  intros some_f some_g. induction f as [|c f IH]; [contradiction|]. destruct f as [|d f]; [simpl; rewrite value_fscale; ring|].
  change (fmul (c :: d :: f) g) with (fadd (fscale c g ++ repeat 0%Z (length (d :: f))) (0%Z :: fmul (d :: f) g)).
  assert (L : S (length (fmul (d :: f) g)) = (length (d :: f) + length g)%nat) by (apply fmul_length; [discriminate | assumption]).
  rewrite value_fadd.
  - rewrite value_shifted, value_fscale. change (value (0%Z :: fmul (d :: f) g) s t) with (inject_Z 0 * power s (length (fmul (d :: f) g)) + t * value (fmul (d :: f) g) s t).
    rewrite IH by discriminate. change (value (c :: d :: f) s t) with (inject_Z c * power s (length (d :: f)) + t * value (d :: f) s t).
    unfold inject_Z at 2. ring.
  - rewrite app_length, fscale_length, repeat_length. simpl length in *. lia.
Qed.

(** ** A form over an interval of its time *)

Fixpoint linear_power (x y : Z) (n : nat) : form := match n with O => [1%Z] | S n => linear x y (linear_power x y n) end.

(** x0 s + x1 t stands for s, and y0 s + y1 t for t. *)
Fixpoint replaced (x0 x1 y0 y1 : Z) (f : form) : form :=
  match f with
  | [] => []
  | c :: g => fadd (fscale c (linear_power x0 x1 (length g))) (linear y0 y1 (replaced x0 x1 y0 y1 g))
  end.

Lemma linear_power_length x y n : length (linear_power x y n) = S n.
Proof. induction n; simpl; [reflexivity|]. rewrite linear_length. lia. Qed.

Lemma replaced_length x0 x1 y0 y1 f : length (replaced x0 x1 y0 y1 f) = length f.
Proof.
  induction f as [|c g IH]; [reflexivity|]. simpl.
  rewrite fadd_length; rewrite fscale_length, linear_power_length; [reflexivity|]. rewrite linear_length, IH. reflexivity.
Qed.

Lemma value_linear_power x y n s t : value (linear_power x y n) s t == power (inject_Z x * s + inject_Z y * t) n.
Proof. induction n; simpl; [unfold inject_Z; ring|]. rewrite value_linear, IHn. reflexivity. Qed.

#[global] Instance power_equal : Proper (Qeq ==> eq ==> Qeq) power.
Proof. intros s t st n m <-. induction n; simpl; [reflexivity|]. rewrite IHn, st. reflexivity. Qed.

Lemma value_equal f s s' t t' : s == s' -> t == t' -> value f s t == value f s' t'.
Proof. intros ss tt. induction f as [|c g IH]; simpl; [reflexivity|]. rewrite IH, ss, tt. reflexivity. Qed.

Lemma value_replaced x0 x1 y0 y1 f s t :
  value (replaced x0 x1 y0 y1 f) s t == value f (inject_Z x0 * s + inject_Z x1 * t) (inject_Z y0 * s + inject_Z y1 * t).
Proof.
  induction f as [|c g IH]; [reflexivity|]. simpl.
  rewrite value_fadd by (rewrite fscale_length, linear_power_length, linear_length, replaced_length; reflexivity).
  rewrite value_fscale, value_linear, value_linear_power, IH. reflexivity.
Qed.

Lemma value_homogeneous k f s t : value f (k * s) (k * t) == power k (pred (length f)) * value f s t.
Proof.
  assert (P : forall n, power (k * s) n == power k n * power s n) by (induction n; simpl; [ring | rewrite IHn; ring]).
  induction f as [|c g IH]; simpl; [ring|]. rewrite IH, P. destruct g as [|d g]; simpl; ring.
Qed.

(** ** Signs *)

Definition all_positive (is_open : bool) (f : form) : bool :=
  match f with
  | [] => false
  | c :: g => (0 <? c)%Z && forallb (Z.leb 0) g && (is_open || (0 <? last f 0)%Z)
  end.

Lemma power_sign s n : 0 <= s -> 0 <= power s n.
Proof. intros H. induction n; simpl; [lra|]. nra. Qed.

Lemma power_positive s n : 0 < s -> 0 < power s n.
Proof. intros H. induction n; simpl; [lra|]. nra. Qed.

Lemma whole_sign c : (0 <= c)%Z -> 0 <= inject_Z c.
Proof. intros H. unfold inject_Z, Qle. simpl. lia. Qed.

Lemma whole_positive c : (0 < c)%Z -> 0 < inject_Z c.
Proof. intros H. unfold inject_Z, Qlt. simpl. lia. Qed.

Lemma value_sign f s t : forallb (Z.leb 0) f = true -> 0 <= s -> 0 <= t -> 0 <= value f s t.
Proof.
  intros H low high. induction f as [|c g IH]; simpl in *; [lra|]. apply andb_prop in H as (first & rest). apply Z.leb_le in first.
  apply whole_sign in first. specialize (IH rest). assert (P := power_sign s (length g) low). nra.
Qed.

Lemma value_last f s t : forallb (Z.leb 0) f = true -> (0 < last f 0)%Z -> 0 <= s -> 0 < t -> 0 < value f s t.
Proof.
  intros H L low high. induction f as [|c g IH]; [simpl in L; lia|]. simpl in H. apply andb_prop in H as (first & rest). apply Z.leb_le in first.
  apply whole_sign in first. destruct g as [|d g].
  - simpl in *. apply whole_positive in L. lra.
  - specialize (IH rest L). assert (P := power_sign s (length (d :: g)) low).
    change (value (c :: d :: g) s t) with (inject_Z c * power s (length (d :: g)) + t * value (d :: g) s t). nra.
Qed.

(** A form with positive coefficients is positive at all times; at the last one, too, unless that is left open. *)
Lemma all_positive_sound is_open f u : all_positive is_open f = true -> 0 <= u <= 1 -> (is_open = true -> u < 1) -> 0 < value f (1 - u) u.
Proof.
  destruct f as [|c g]; [discriminate|]. intros H (low & high) early. unfold all_positive in H. apply andb_prop in H as (H & at_last).
  apply andb_prop in H as (first & rest). apply Z.ltb_lt in first. destruct (Qlt_le_dec u 1) as [before|after].
  - simpl. apply whole_positive in first. assert (P := power_positive (1 - u) (length g) ltac:(lra)).
    assert (R := value_sign g (1 - u) u rest ltac:(lra) low). nra.
  - destruct is_open; [specialize (early eq_refl); lra|]. apply Z.ltb_lt in at_last.
    apply value_last; try lra; [|exact at_last]. simpl. rewrite rest. replace (0 <=? c)%Z with true by (symmetry; apply Z.leb_le; lia). reflexivity.
Qed.

(** ** The largest coefficients of several forms *)

Fixpoint fmax (f g : form) : form :=
  match f, g with
  | x :: f, y :: g => Z.max x y :: fmax f g
  | _, _ => []
  end.

Definition below (f g : form) : Prop := Forall2 Z.le f g.

Lemma below_length f g : below f g -> length f = length g.
Proof. induction 1; simpl; congruence. Qed.

Lemma value_below f g s t : below f g -> 0 <= s -> 0 <= t -> value f s t <= value g s t.
Proof.
  intros H low high. induction H as [|x y f g xy fg IH]; simpl; [lra|]. rewrite (below_length f g fg).
  assert (P := power_sign s (length g) low). assert (inject_Z x <= inject_Z y) by (unfold inject_Z, Qle; simpl; lia). nra.
Qed.

Lemma below_fmax f g : length f = length g -> below f (fmax f g) /\ below g (fmax f g) /\ length (fmax f g) = length f.
Proof.
  revert g. induction f as [|x f IH]; intros [|y g]; simpl; intros E; try discriminate; [repeat constructor|]. injection E as E.
  destruct (IH g E) as (A & B & C). repeat split; [constructor; [lia|]; assumption | constructor; [lia|]; assumption | congruence].
Qed.

Lemma below_trans f g h : below f g -> below g h -> below f h.
Proof. intros A. revert h. induction A; intros h' B; inversion B; subst; constructor; [lia|]. apply IHA. assumption. Qed.

Lemma below_refl f : below f f.
Proof. induction f; constructor; [lia | assumption]. Qed.

Lemma fold_fmax_above (l : list form) : forall m, (forall f, In f l -> length f = length m) ->
  below m (fold_left fmax l m) /\ (forall f, In f l -> below f (fold_left fmax l m)) /\ length (fold_left fmax l m) = length m.
Proof.
  induction l as [|g l IH]; simpl; intros m same_length; [repeat split; [apply below_refl | contradiction]|].
  destruct (below_fmax m g (eq_sym (same_length g (or_introl eq_refl)))) as (A & B & C).
  destruct (IH (fmax m g)) as (D & E & F).
  { intros f in_l. rewrite C. apply same_length. auto. }
  repeat split; [eapply below_trans; eassumption | | congruence].
  intros f [<-|in_l]; [eapply below_trans; eassumption | auto].
Qed.
