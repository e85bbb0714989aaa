(* SHA-256, FIPS 180-4, on 32-bit words in OCaml's 63-bit integers. *)

let primes n =
  let rec go k found = if List.length found = n then List.rev found
    else go (k + 1) (if List.exists (fun p -> k mod p = 0) found then found else k :: found) in
  go 2 []

(* The first 32 bits of the fractional part of a root: floor(2^32 root(p)) modulo 2^32. *)
let root_bits power p =
  let root = if power = 2 then Z.root else Z.root in
  Z.to_int (Z.logand (root (Z.shift_left (Z.of_int p) (32 * power)) power) (Z.of_string "0xffffffff"))

let constants = Array.of_list (List.map (root_bits 3) (primes 64))
let start = List.map (root_bits 2) (primes 8)

let hex data =
  let mask = 0xffffffff in
  let turn x n = ((x lsr n) lor (x lsl (32 - n))) land mask in
  let length = String.length data in
  let blocks = (length + 9 + 63) / 64 in
  let bytes = Bytes.make (64 * blocks) '\000' in
  Bytes.blit_string data 0 bytes 0 length;
  Bytes.set bytes length '\x80';
  Bytes.set_int64_be bytes ((64 * blocks) - 8) (Int64.of_int (8 * length));
  let h = Array.of_list start and w = Array.make 64 0 in
  for block = 0 to blocks - 1 do
    for t = 0 to 15 do
      w.(t) <- Int32.to_int (Bytes.get_int32_be bytes ((64 * block) + (4 * t))) land mask
    done;
    for t = 16 to 63 do
      let x = w.(t - 15) and y = w.(t - 2) in
      let s0 = turn x 7 lxor turn x 18 lxor (x lsr 3) and s1 = turn y 17 lxor turn y 19 lxor (y lsr 10) in
      w.(t) <- (w.(t - 16) + s0 + w.(t - 7) + s1) land mask
    done;
    let v = Array.copy h in
    for t = 0 to 63 do
      let a = v.(0) and b = v.(1) and c = v.(2) and e = v.(4) and f = v.(5) and g = v.(6) in
      let s1 = turn e 6 lxor turn e 11 lxor turn e 25 and choice = (e land f) lxor (lnot e land mask land g) in
      let t1 = v.(7) + s1 + choice + constants.(t) + w.(t) in
      let s0 = turn a 2 lxor turn a 13 lxor turn a 22 and majority = (a land b) lxor (a land c) lxor (b land c) in
      Array.blit v 0 v 1 7;
      v.(4) <- (v.(4) + t1) land mask;
      v.(0) <- (t1 + s0 + majority) land mask
    done;
    Array.iteri (fun i x -> h.(i) <- (h.(i) + x) land mask) v
  done;
  String.concat "" (List.map (Printf.sprintf "%08x") (Array.to_list h))
