# refused TEXT WORDS: prints the words unless the program refuses them with status 2, nothing on standard output, and one
# line on standard error that holds the text.
refused() {
  says=$1; shift
  error=$(tetracone "$@" 2>&1 >printed); status=$?
  case $error in *"$says"*) ;; *) status=other ;; esac
  if [ "$status" != 2 ] || [ -s printed ] || [ ${#error} -le 9 ] || [ "$(printf '%s\n' "$error" | wc -l)" != 1 ]; then echo "$@: $error"; fi
}
