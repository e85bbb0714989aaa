(** A ray that meets no piece of a body, at all or before its first hit. *)
Require Import List ZArith QArith Lia Lqa Permutation.
From Certificates Require Import Space Exact Faces Cuts Covers Claims.
Import ListNotations.
Open Scope Z_scope.

(** What is shown of piece number k at o + s d: nothing where the ray has an end, before it; at the end itself for the pieces below a number, or for all. *)
Definition before (last : option Q) (first : option positive) (k : positive) (s : Q) : Prop :=
  (0 <= s)%Q /\ match last with
                | None => True
                | Some t => (s < t)%Q \/ (s <= t)%Q /\ match first with None => True | Some j => (k < j)%positive end
                end.

Definition all_from (first : option positive) (l : list (positive * zface)) : bool :=
  match first with None => false | Some j => forallb (fun x => (j <=? fst x)%positive) l end.

(** As [beyond], or equal. *)
Definition not_before (m : grid) (k : Z) (uk uf : positive) (corners : list grid) : bool :=
  match reach (opposite m) corners with
  | Some r => k * Zpos uf <=? - r * Zpos uk
  | None => true
  end.

Definition corners_of (l : list (positive * zface)) : list grid := flat_map (fun x => concat (snd x)) l.

(** o and d are over the unit u; the ray's end is o + t d. *)
Definition ray_leaf (u : positive) (o d : grid) (last : option Q) (first : option positive) (uf : positive) (c : passage) (l : list (positive * zface)) : option Z :=
  match c, last with
  | Passes m, None => if (zdot m d <=? 0) && beyond m (zdot m o) u uf (corners_of l) then Some 0 else None
  | Passes m, Some t =>
      let at_end := zdot m o * Zpos (Qden t) + zdot m d * Qnum t in
      if beyond m (zdot m o) u uf (corners_of l) &&
         (if all_from first l then not_before else beyond) m at_end (u * Qden t)%positive uf (corners_of l)
      then Some 0 else None
  | Touched, Some t => if (Qnum t =? 0) && all_from first l then Some 0 else None
  | _, _ => None
  end.

Definition check_ray (u : positive) (o d : grid) (last : option Q) (first : option positive) (m : zpose) (b : zbody) (c : passage) : bool :=
  match passages (ray_leaf u o d last first (unit_at m b)) c (place_pieces m b) with Some _ => true | None => false end.

Definition on_ray (u : positive) (o d : grid) (s : Q) : point := plus (over u o) (times s (over u d)).

Definition missed (u : positive) (o d : grid) (last : option Q) (first : option positive) (uf : positive) (x : positive * zface) (_ : Z) : Prop :=
  forall s, before last first (fst x) s -> ~ hull (map (over uf) (concat (snd x))) (on_ray u o d s).

Lemma not_before_sound m k uk uf corners v : not_before m k uk uf corners = true -> In v corners -> (k # uk <= dot (over 1 m) (over uf v))%Q.
Proof.
  unfold not_before. intros H v_in. rewrite dot_over.
  destruct (reach (opposite m) corners) as [r|] eqn:reached; [|apply reach_none in reached; subst; contradiction].
  apply Z.leb_le in H. assert (A := reach_above _ _ _ reached v v_in).
  assert (O : zdot (opposite m) v = - zdot m v) by (unfold zdot, opposite; simpl; ring).
  unfold Qle; simpl. nia.
Qed.

Open Scope Q_scope.

Lemma beyond_hull m k u uf l x p : beyond m k u uf (corners_of l) = true -> In x l -> hull (map (over uf) (concat (snd x))) p -> k # u < dot (over 1 m) p.
Proof.
  intros H x_in at_p.
  assert (inside : forall v, In v (concat (snd x)) -> In v (corners_of l)) by (intros v v_in; apply in_flat_map; exists x; auto).
  clear x_in. induction at_p as [v p v_in pv|p q r s at_p IHp at_q IHq low high r_is].
  - apply in_map_iff in v_in as (w & <- & w_in). rewrite pv. apply (beyond_sound _ _ _ _ _ _ H). auto.
  - assert (split_dot : dot (over 1 m) r == (1 - s) * dot (over 1 m) p + s * dot (over 1 m) q)
      by (rewrite r_is; unfold dot, plus, times; simpl; ring).
    rewrite split_dot. destruct (Qlt_le_dec 0 s); nra.
Qed.

Lemma not_before_hull m k u uf l x p : not_before m k u uf (corners_of l) = true -> In x l -> hull (map (over uf) (concat (snd x))) p ->
  k # u <= dot (over 1 m) p.
Proof.
  intros H x_in at_p.
  assert (inside : forall v, In v (concat (snd x)) -> In v (corners_of l)) by (intros v v_in; apply in_flat_map; exists x; auto).
  clear x_in. induction at_p as [v p v_in pv|p q r s at_p IHp at_q IHq low high r_is].
  - apply in_map_iff in v_in as (w & <- & w_in). rewrite pv. apply (not_before_sound _ _ _ _ _ _ H). auto.
  - assert (split_dot : dot (over 1 m) r == (1 - s) * dot (over 1 m) p + s * dot (over 1 m) q)
      by (rewrite r_is; unfold dot, plus, times; simpl; ring).
    rewrite split_dot. nra.
Qed.

Lemma on_ray_dot m u o d s : dot (over 1 m) (on_ray u o d s) == (zdot m o # u) + s * (zdot m d # u).
Proof.
  transitivity (dot (over 1 m) (over u o) + s * dot (over 1 m) (over u d)); [unfold on_ray, dot, plus, times; simpl; ring|].
  rewrite !dot_over. reflexivity.
Qed.

Lemma at_end_is m u o d t : (zdot m o * Zpos (Qden t) + zdot m d * Qnum t # u * Qden t) == (zdot m o # u) + t * (zdot m d # u).
Proof. destruct t as [n e]. unfold Qeq, Qplus, Qmult; cbn [Qnum Qden]. rewrite ?Pos2Z.inj_mul. ring. Qed.

Lemma ray_leaf_sound u o d last first uf c l w : ray_leaf u o d last first uf c l = Some w ->
  exists ws, Forall2 (missed u o d last first uf) l ws /\ sum (fun x => x) ws = w.
Proof.
  intros H.
  assert (each : forall x, In x l -> missed u o d last first uf x 0%Z).
  { intros (k & f) x_in s (nonnegative & in_time) at_s. unfold ray_leaf in H. destruct c as [m|n v| |parts]; try discriminate.
    - assert (D := on_ray_dot m u o d s). destruct last as [t|].
      + match type of H with (if ?e then _ else _) = _ => destruct e eqn:accepted; [|discriminate] end.
        apply andb_prop in accepted as (start & finish).
        assert (S := beyond_hull _ _ _ _ _ _ _ start x_in at_s). simpl in in_time.
        assert (E := at_end_is m u o d t).
        destruct (all_from first l) eqn:from.
        * assert (F := not_before_hull _ _ _ _ _ _ _ finish x_in at_s). rewrite D in S, F. rewrite E in F.
          assert (s < t).
          { destruct in_time as [?|(_ & below)]; [assumption|]. destruct first as [j|]; [|discriminate].
            unfold all_from in from. rewrite forallb_forall in from. specialize (from _ x_in). apply Pos.leb_le in from. simpl in from. lia. }
          nra.
        * assert (F := beyond_hull _ _ _ _ _ _ _ finish x_in at_s). rewrite D in S, F. rewrite E in F.
          assert (s <= t) by (destruct in_time as [?|(? & _)]; [apply Qlt_le_weak|]; assumption). destruct (Qlt_le_dec 0 (zdot m d # u)); nra.
      + destruct ((zdot m d <=? 0)%Z && _) eqn:accepted; [|discriminate]. apply andb_prop in accepted as (backward & start).
        assert (S := beyond_hull _ _ _ _ _ _ _ start x_in at_s). rewrite D in S.
        assert (zdot m d # u <= 0) by (apply Z.leb_le in backward; unfold Qle; simpl; lia). nra.
    - destruct last as [t|]; [|discriminate].
      destruct ((Qnum t =? 0)%Z && _) eqn:accepted; [|discriminate]. apply andb_prop in accepted as (none & from).
      apply Z.eqb_eq in none. assert (t == 0) by (unfold Qeq; simpl; lia).
      destruct in_time as [early|(_ & below)]; [lra|]. unfold all_from in from. destruct first as [j|]; [|discriminate].
      rewrite forallb_forall in from. specialize (from _ x_in). apply Pos.leb_le in from. simpl in from, below. lia. }
  assert (w = 0%Z).
  { unfold ray_leaf in H. destruct c, last; try discriminate;
      match type of H with (if ?e then _ else _) = _ => destruct e; [|discriminate] end; congruence. }
  subst w. exists (map (fun _ => 0%Z) l). clear H. split.
  - induction l as [|x l IH]; simpl; constructor; [apply each; left; reflexivity | apply IH; intros; apply each; right; assumption].
  - induction l; simpl; auto. apply IHl. intros. apply each. right. assumption.
Qed.

(** Pieces are numbered in the order of faces. None of them has a point of the ray before its end; at the end, none that is numbered below [first]. *)
Theorem ray_misses u o d last first m b c : check_body b = true -> check_ray u o d last first m b c = true ->
  forall k piece s, In (k, piece) (numbered 1 (pieces (cut_faces b))) -> before last first k s ->
  ~ hull (map (moved m b) (concat piece)) (on_ray u o d s).
Proof.
  intros body_b accepted k piece s piece_in in_time at_s. unfold check_ray in accepted.
  destruct (passages _ c (place_pieces m b)) as [w|] eqn:W; [|discriminate].
  destruct (passages_sound _ (missed u o d last first (unit_at m b)) (ray_leaf_sound u o d last first (unit_at m b)) _ _ _ W) as (ws & all & _).
  apply (Permutation_in _ (body_is_numbered b body_b)) in piece_in.
  unfold place_pieces in all. rewrite contents_map in all.
  assert (shown : missed u o d last first (unit_at m b) (k, place_face m b piece) 0%Z).
  { clear W. revert ws all. induction (contents (groups b)) as [|x l IH]; intros ws all; [contradiction|].
    inversion all; subst. destruct piece_in as [->|piece_in]; [assumption | eauto]. }
  apply (shown s); [exact in_time|]. unfold place_face. simpl snd. rewrite <- concat_map.
  apply (hull_same _ (map (moved m b) (concat piece)) (on_ray u o d s) (on_ray u o d s)); [apply corners_same | reflexivity | exact at_s].
Qed.

(** The surface has no point of the ray before its end. *)
Theorem ray_is_free u o d last first m b c : check_body b = true -> check_ray u o d last first m b c = true ->
  forall s, 0 <= s -> match last with None => True | Some t => s < t end -> ~ surface (body_at (moved m b) b) (on_ray u o d s).
Proof.
  intros body_b accepted s nonnegative early at_s.
  destruct (surface_in_pieces b (moved m b) _ body_b at_s) as (piece & piece_in & in_hull).
  apply (Permutation_in _ (body_is_whole b body_b)) in piece_in. rewrite <- (numbered_pieces 1 (pieces (cut_faces b))) in piece_in.
  apply in_map_iff in piece_in as ((k & x) & E & piece_in). simpl in E. subst x.
  apply (ray_misses u o d last first m b c body_b accepted k piece s piece_in); [|exact in_hull].
  split; [assumption|]. destruct last; auto.
Qed.
