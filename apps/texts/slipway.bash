# bash completion for slipway; made by: slipway help --as bash
_slipway() {
    local now=${2#=} word text more
    COMPREPLY=()
    while IFS=$'\t' read -r word text; do
        case $word in
        :file)
            compopt -o filenames 2>/dev/null
            mapfile -t more < <(compgen -f -X "!$text" -o plusdirs -- "$now")
            COMPREPLY+=("${more[@]}") ;;
        :folder)
            compopt -o filenames 2>/dev/null
            mapfile -t more < <(compgen -d -- "$now")
            COMPREPLY+=("${more[@]}") ;;
        *)
            [[ $word != *= ]] || compopt -o nospace 2>/dev/null
            COMPREPLY+=("$word") ;;
        esac
    done < <("${COMP_WORDS[0]}" help --as complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -F _slipway slipway
