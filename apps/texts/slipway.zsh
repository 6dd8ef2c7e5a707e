#compdef slipway
# made by: slipway help --as zsh
_slipway() {
    local -a found settings
    local word text
    while IFS=$'\t' read -r word text; do
        case $word in
        :file) _files -g "$text" ;;
        :folder) _files -/ ;;
        *=) settings+=("$word") ;;
        *) found+=("${word//:/\\:}${text:+:}$text") ;;
        esac
    done < <($words[1] help --as complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)
    (( $#settings )) && compadd -S '' -a settings
    (( $#found )) && _describe slipway found
}
_slipway "$@"
