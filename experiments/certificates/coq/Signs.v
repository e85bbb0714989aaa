(** Signs of the ten determinants of five vectors, and what they say about four tetrahedra: by trying all signs. *)
Require Import List ZArith QArith Lia Lqa Bool.
From Certificates Require Import Space Exact Faces.
Import ListNotations.

Definition sign (x : Q) : comparison := (x ?= 0)%Q.

Definition product (s t : comparison) : comparison :=
  match s with Eq => Eq | Gt => t | Lt => CompOpp t end.

(** Three numbers whose sum is 0 are all 0, or have both signs. *)
Definition may_cancel (s t u : comparison) : bool :=
  match s, t, u with
  | Eq, Eq, Eq => true
  | _, _, _ => (let has x := match s, t, u with | _, _, _ => existsb (fun y => match x, y with Lt, Lt | Gt, Gt => true | _, _ => false end) [s; t; u] end in
                has Lt && has Gt)
  end.

(** The signed crossing of a ray d with a triangle a, b, c, from the signs of d a b, d b c, d c a and a b c. *)
Definition hit (ab bc ca volume : comparison) : Z :=
  match ab, bc, ca, volume with
  | Gt, Gt, Gt, Gt => 1
  | Lt, Lt, Lt, Lt => -1
  | _, _, _, _ => 0
  end.

(** The ray meets no edge of the triangle, and the triangle has not the origin: it may pass by, or cross within. *)
Definition is_generic (ab bc ca volume : comparison) : bool :=
  match ab, bc, ca with
  | Gt, Lt, _ | Lt, Gt, _ | Gt, _, Lt | Lt, _, Gt | _, Gt, Lt | _, Lt, Gt | Eq, Eq, Eq => true
  | Gt, Gt, Gt | Lt, Lt, Lt => negb (match volume with Eq => true | _ => false end)
  | Gt, _, _ | _, Gt, _ | _, _, Gt => match volume with Lt => true | _ => false end
  | _, _, _ => match volume with Gt => true | _ => false end
  end.

Definition is_null (s : comparison) : bool := match s with Eq => true | _ => false end.

Definition all_signs (f : comparison -> bool) : bool := f Lt && f Eq && f Gt.

Lemma all_signs_all f : all_signs f = true -> forall s, f s = true.
Proof. unfold all_signs. intros H s. apply andb_prop in H as (H & G). apply andb_prop in H as (L & E). destruct s; assumption. Qed.

(** Whether the tetrahedron e, a, b, c holds the origin, with its sign: the signs of a b c, e b c, e c a and e a b. *)
Definition encloses (abc ebc eca eab : comparison) : Z := hit abc (CompOpp ebc) (CompOpp eca) (CompOpp eab).

(** The crossings of d with the four triangles of e, a, b, c add up to what does not depend on d. *)
Definition adds_up (dea deb dec dab dbc dca eab ebc eca abc : comparison) : bool :=
  (hit dab dbc dca abc =? encloses abc ebc eca eab + hit dea dab (CompOpp deb) eab + hit deb dbc (CompOpp dec) ebc + hit dec dca (CompOpp dea) eca)%Z.

(** e is in no plane of two of the other vectors, but where these are on a line. *)
Definition e_is_generic (dea deb dec dab dbc dca eab ebc eca abc : comparison) : bool :=
  implb (is_null dea) (is_null dab && is_null dca) && implb (is_null deb) (is_null dab && is_null dbc) &&
  implb (is_null dec) (is_null dca && is_null dbc) && implb (is_null eab) (is_null dab && is_null abc) &&
  implb (is_null ebc) (is_null dbc && is_null abc) && implb (is_null eca) (is_null dca && is_null abc) &&
  implb (is_null dea && is_null deb) (is_null abc).

Definition relations (dea deb dec dab dbc dca eab ebc eca abc : comparison) : bool :=
  may_cancel (product dea dbc) (product deb dca) (product dec dab) && may_cancel (product dea ebc) (product deb eca) (product dec eab) &&
  may_cancel (product dea abc) (product dab eca) (CompOpp (product dca eab)) && may_cancel (CompOpp (product deb abc)) (product dab ebc) (CompOpp (product dbc eab)) &&
  may_cancel (product dec abc) (product dca ebc) (CompOpp (product dbc eca)).

Theorem four_triangles : forall dab dbc dca abc dea deb dec eab ebc eca, is_generic dab dbc dca abc = true ->
  e_is_generic dea deb dec dab dbc dca eab ebc eca abc = true -> relations dea deb dec dab dbc dca eab ebc eca abc = true ->
  adds_up dea deb dec dab dbc dca eab ebc eca abc = true.
Proof.
  assert (all : all_signs (fun dab => all_signs (fun dbc => all_signs (fun dca => all_signs (fun abc =>
    if is_generic dab dbc dca abc then
      all_signs (fun dea => all_signs (fun deb => all_signs (fun dec =>
        if may_cancel (product dea dbc) (product deb dca) (product dec dab) then
          all_signs (fun eab => all_signs (fun ebc => all_signs (fun eca =>
            implb (e_is_generic dea deb dec dab dbc dca eab ebc eca abc && relations dea deb dec dab dbc dca eab ebc eca abc)
                  (adds_up dea deb dec dab dbc dca eab ebc eca abc)))) else true))) else true)))) = true) by (vm_compute; reflexivity).
  intros dab dbc dca abc dea deb dec eab ebc eca generic e_generic related.
  apply all_signs_all with (s := dab) in all. apply all_signs_all with (s := dbc) in all. apply all_signs_all with (s := dca) in all.
  apply all_signs_all with (s := abc) in all. rewrite generic in all.
  apply all_signs_all with (s := dea) in all. apply all_signs_all with (s := deb) in all. apply all_signs_all with (s := dec) in all.
  assert (first : may_cancel (product dea dbc) (product deb dca) (product dec dab) = true)
    by (unfold relations in related; repeat (apply andb_prop in related as (related & _)); exact related).
  rewrite first in all.
  apply all_signs_all with (s := eab) in all. apply all_signs_all with (s := ebc) in all. apply all_signs_all with (s := eca) in all.
  rewrite e_generic, related in all. exact all.
Qed.

(** ** Signs of rationals *)

Open Scope Q_scope.

Lemma sign_product x y : sign (x * y) = product (sign x) (sign y).
Proof.
  unfold sign. destruct (Qcompare_spec x 0) as [X|X|X], (Qcompare_spec y 0) as [Y|Y|Y]; cbn [product CompOpp];
    first [rewrite <- Qeq_alt; rewrite ?X, ?Y; ring | rewrite <- Qlt_alt; nra | rewrite <- Qgt_alt; nra].
Qed.

Lemma sign_opposite x y : x == - y -> sign x = CompOpp (sign y).
Proof.
  unfold sign. intros H. destruct (Qcompare_spec y 0) as [Y|Y|Y]; cbn [CompOpp]; [rewrite <- Qeq_alt; lra | rewrite <- Qgt_alt; lra | rewrite <- Qlt_alt; lra].
Qed.

Lemma may_cancel_sound x y z : x + y + z == 0 -> may_cancel (sign x) (sign y) (sign z) = true.
Proof.
  unfold sign. intros H. destruct (Qcompare_spec x 0), (Qcompare_spec y 0), (Qcompare_spec z 0); try reflexivity; exfalso; lra.
Qed.

(** The sign of a sum with positive weights, where the signs of its terms say it. *)
Definition agrees (s t u whole : comparison) : bool :=
  match s, t, u with
  | Eq, Eq, Eq => is_null whole
  | Gt, Lt, _ | Lt, Gt, _ | Gt, _, Lt | Lt, _, Gt | _, Gt, Lt | _, Lt, Gt => true
  | Gt, _, _ | _, Gt, _ | _, _, Gt => match whole with Gt => true | _ => false end
  | _, _, _ => match whole with Lt => true | _ => false end
  end.

Lemma agrees_sound f g h x y z w : 0 < f -> 0 < g -> 0 < h -> w == f * x + g * y + h * z -> agrees (sign x) (sign y) (sign z) (sign w) = true.
Proof.
  intros F G H W. unfold sign.
  assert (positive : forall k v, 0 < k -> 0 < v -> 0 < k * v) by (intros; nra).
  assert (negative : forall k v, 0 < k -> v < 0 -> k * v < 0) by (intros; nra).
  assert (null : forall k v, v == 0 -> k * v == 0) by (intros k v E; rewrite E; ring).
  destruct (Qcompare_spec x 0) as [X|X|X], (Qcompare_spec y 0) as [Y|Y|Y], (Qcompare_spec z 0) as [Z|Z|Z]; try reflexivity;
    (apply (null f) in X || apply (negative f) in X || apply (positive f) in X; auto);
    (apply (null g) in Y || apply (negative g) in Y || apply (positive g) in Y; auto);
    (apply (null h) in Z || apply (negative h) in Z || apply (positive h) in Z; auto);
    destruct (Qcompare_spec w 0); try reflexivity; exfalso; lra.
Qed.

(** A plane between the ray and the triangle. *)
Theorem passing_is_generic : forall dab dbc dca abc md, md <> Gt -> agrees dab dbc dca (product abc md) = true ->
  is_generic dab dbc dca abc = true /\ hit dab dbc dca abc = 0%Z.
Proof. intros [] [] [] [] []; simpl; intros; try congruence; auto. Qed.

Definition turn_sign (ua ub ab : comparison) : Z :=
  match ua, ub, ab with Lt, Gt, Gt => 1%Z | Gt, Lt, Lt => (-1)%Z | _, _, _ => 0%Z end.

Definition off_edge (ua ub ab : comparison) : bool := negb (is_null ab) || match product ua ub with Gt => true | _ => false end.

(** The winding number of a crossing about a triangle. *)
Theorem crossing_is_generic : forall ua ub uc ab bc ca abc, ua <> Eq -> ub <> Eq -> uc <> Eq ->
  off_edge ua ub ab = true -> off_edge ub uc bc = true -> off_edge uc ua ca = true ->
  may_cancel (product ua bc) (product ub ca) (product uc ab) = true -> agrees ab bc ca abc = true ->
  is_generic ab bc ca abc = true /\ hit ab bc ca abc = (turn_sign ua ub ab + turn_sign ub uc bc + turn_sign uc ua ca)%Z.
Proof.
  intros [] [] [] [] [] [] []; simpl; intros; try congruence; auto; try discriminate.
Qed.
