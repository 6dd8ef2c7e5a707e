# made by: slipway help --as fish
function __slipway
    set -l typed (commandline -opc) (commandline -ct)
    for line in ($typed[1] help --as complete -- $typed[2..] 2>/dev/null)
        set -l part (string split \t -- $line)
        switch $line
            case ':file*'
                __fish_complete_suffix (string sub -s 2 -- $part[2])
            case ':folder*'
                __fish_complete_directories
            case '*'
                echo $line
        end
    end
end
complete -c slipway -f -a '(__slipway)'
